#include <unistd.h>
#include <verify/message.hpp>
#include <verify/temporary_store.hpp>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <stdexcept>

#include <patchproof/report/claim_json.hpp>

namespace patchproof {

namespace {

[[noreturn]] void fail(const char* doing) {
  throw std::runtime_error{std::string{"cannot "} + doing +
                           " a temporary file: " + std::strerror(errno)};
}

int nameless_file() {
  std::string path = (std::filesystem::temp_directory_path() / "patchproof_XXXXXX").string();
  const int descriptor = ::mkstemp(path.data());
  if (descriptor < 0) fail("make");
  ::unlink(path.c_str());
  return descriptor;
}

Message packed(const CaseRecord& of) {
  Message message{{"name", of.name}, {"title", of.title}, {"excerpt", of.excerpt}};
  add_place(of.place, message);
  message["claims"] = Message::array();
  for (const ClaimRecord& claim : of.claims)
    message["claims"].push_back({to_json(claim, of.name), claim.time.count(), claim.position});
  message["shown"] = Message::array();
  for (const ShownRecord& shown : of.shown) message["shown"].push_back(to_json(shown, of.name));
  if (of.audit)
    message["audit"] = {of.audit->text, of.audit->flagged, of.audit->json, of.audit->has_flagged,
                        of.audit->is_lost};
  return message;
}

CaseRecord unpacked_case(const Message& message) {
  CaseRecord of;
  of.name = message.at("name").get<std::string>();
  of.title = message.at("title").get<std::string>();
  of.excerpt = message.at("excerpt").get<std::string>();
  of.place = place_from(message);
  for (const Message& one : message.at("claims")) {
    ClaimRecord& claim = of.claims.emplace_back(claim_from(one.at(0)));
    claim.time = std::chrono::microseconds{one.at(1).get<std::int64_t>()};
    claim.position = one.at(2).get<std::size_t>();
  }
  for (const Message& one : message.at("shown")) of.shown.push_back(shown_from(one));
  if (message.contains("audit")) {
    const Message& audit = message.at("audit");
    of.audit = AuditRecord{audit.at(0).get<std::string>(), audit.at(1).get<std::string>(),
                           audit.at(2).get<std::string>(), audit.at(3).get<bool>(),
                           audit.at(4).get<bool>()};
  }
  return of;
}

Message packed(const FileRecord& file) {
  Message message{{"path", file.path}, {"unreadable", file.unreadable}};
  message["diagnostics"] = Message::array();
  for (const DiagnosticRecord& diagnostic : file.diagnostics)
    message["diagnostics"].push_back({to_json(diagnostic), diagnostic.text});
  message["cases"] = Message::array();
  for (const CaseRecord& of : file.cases) message["cases"].push_back(packed(of));
  return message;
}

FileRecord unpacked_file(const Message& message) {
  FileRecord file;
  file.path = message.at("path").get<std::string>();
  file.unreadable = message.at("unreadable").get<std::string>();
  for (const Message& one : message.at("diagnostics"))
    file.diagnostics.emplace_back(diagnostic_from(one.at(0))).text = one.at(1).get<std::string>();
  for (const Message& one : message.at("cases")) file.cases.push_back(unpacked_case(one));
  return file;
}

}  // namespace

TemporaryStore::~TemporaryStore() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void TemporaryStore::add(const FileRecord& file) {
  if (descriptor_ < 0) descriptor_ = nameless_file();
  if (!send(descriptor_, packed(file))) fail("write");
}

void TemporaryStore::for_each(const std::function<void(const FileRecord&)>& see) {
  if (descriptor_ < 0) return;
  if (::lseek(descriptor_, 0, SEEK_SET) < 0) fail("read");
  Mailbox mailbox{descriptor_};
  while (mailbox.receive())
    while (const std::optional<Message> message = mailbox.next()) see(unpacked_file(*message));
}

}  // namespace patchproof
