#include <patchproof/mutation/data_candidate.hpp>

#include <algorithm>

#include <patchproof/mutation/numeric.hpp>

namespace patchproof {

namespace {

/// How many changes there are of one number.
constexpr std::size_t changes_of_one = 2;
/// Coordinates beyond these are left alone.
constexpr std::size_t most_coordinates = 3;

bool is_curve(const Data& data) {
  return data.is_function && data.statement->declarators.front().parameters.size() == 1;
}

// The height of the curve raised at the end where t or 1-t is 1.
DataCandidate raised(const Data& curve, bool at_end) {
  const std::string t = curve.statement->declarators.front().parameters.front().text;
  const Datum& height = curve.numbers.back();
  const Span& span = height.value->span;
  const std::string old = as_text(span);
  const std::string more = at_end ? t : "1-" + t;
  const Edit edit{span.begin, span.end, old == "0" ? more : old + " + " + more, "datum"};
  return {{height}, {edit}, true};
}

/// Two curves that meet can have their common end elsewhere.
void add_corners(const Data& first, const Data& second, std::vector<DataCandidate>& result) {
  if (!is_curve(first) || !is_curve(second)) return;
  for (const bool first_end : {false, true})
    for (const bool second_end : {false, true})
      result.push_back(both(raised(first, first_end), raised(second, second_end)));
}

}  // namespace

std::string in_words(const DataCandidate& candidate, const DataCandidate& together) {
  std::string result;
  for (const Datum& datum : candidate.numbers) {
    const Span& entry = datum.entry;
    std::vector<Edit> inside;
    for (Edit edit : together.edits) {
      if (edit.begin < entry.begin || edit.end > entry.end) continue;
      edit.begin -= entry.begin;
      edit.end -= entry.begin;
      inside.push_back(std::move(edit));
    }
    std::sort(inside.begin(), inside.end());
    const std::string old = as_text(entry);
    result += (result.empty() ? "" : " and ") + datum.owner + " = " + changed(old, inside) +
              " in place of " + old;
  }
  return result;
}

bool overlaps(const DataCandidate& a, const DataCandidate& b) {
  for (const Edit& first : a.edits)
    for (const Edit& second : b.edits)
      if (overlap(first, second)) return true;
  return false;
}

DataCandidate both(const DataCandidate& a, const DataCandidate& b) {
  DataCandidate result = a;
  result.numbers.insert(result.numbers.end(), b.numbers.begin(), b.numbers.end());
  result.edits.insert(result.edits.end(), b.edits.begin(), b.edits.end());
  result.moves_ends = a.moves_ends || b.moves_ends;
  return result;
}

std::vector<DataCandidate> data_candidates(const std::vector<const Data*>& hiding,
                                           const std::vector<Data>& all) {
  std::vector<DataCandidate> result;
  for (std::size_t change = 0; change < changes_of_one; ++change)
    for (std::size_t coordinate = 0; coordinate < most_coordinates; ++coordinate)
      for (const Data* data : hiding)
        for (const Datum& datum : data->numbers)
          if (datum.from_last == coordinate)
            // The first change of a function vanishes at its ends.
            result.push_back(
                {{datum}, {small_changes(*data, datum)[change]}, data->is_function && change > 0});
  for (std::size_t k = 0; k < all.size(); ++k)
    for (std::size_t l = k + 1; l < all.size(); ++l) add_corners(all[k], all[l], result);
  return result;
}

}  // namespace patchproof
