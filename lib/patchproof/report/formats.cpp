#include <patchproof/report/formats.hpp>

#include <stdexcept>

#include <patchproof/report/json_report.hpp>
#include <patchproof/report/text_report.hpp>

namespace patchproof {

const std::vector<Format>& formats() {
  static const std::vector<Format> all{
      {"text", text_report},
      {"json", json_report},
  };
  return all;
}

void write(const RunRecord& run, std::string_view format, const ReportStyle& style,
           const ReportSink& sink) {
  for (const Format& known : formats())
    if (known.name == format) return known.write(run, style, sink);
  throw std::invalid_argument{"there is no format '" + std::string{format} + "'"};
}

std::string written(const RunRecord& run, std::string_view format, const ReportStyle& style) {
  std::string text;
  write(run, format, style, [&](std::string_view piece) { text += piece; });
  return text;
}

std::string written(const Report& report, std::string_view format, const ReportStyle& style) {
  return written(record_of(report), format, style);
}

}  // namespace patchproof
