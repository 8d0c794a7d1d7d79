#include "core/session/document_text.h"

#include <nlohmann/json.hpp>
#include <utility>

#include "core/base/error.h"
#include "core/io/json_input.h"
#include "core/io/template_file.h"

namespace archetype {

using Json = nlohmann::json;

namespace {

constexpr int levels_around_template = 2;  // the document and its list

}  // namespace

std::string format_document(const Document& document) {
  Json json = {{"format", "archetype-document"}, {"version", 1}, {"active", document.active}};
  json["templates"] = Json::array();
  for (const auto& part_template : document.templates)
    json["templates"].push_back(Json::parse(format_template(*part_template)));
  return json.dump();
}

Document parse_document(std::string_view text, const std::filesystem::path& name) {
  const Json json = parse_json(text, name, max_json_depth + levels_around_template);
  const bool ours = json.is_object() && json.contains("format") && json["format"] == "archetype-document";
  if (!ours || !json.contains("templates") || !json["templates"].is_array())
    throw InputError(name, "", "expected the templates that were being edited");
  Document document;
  for (const Json& part_template : json["templates"])
    document.templates.push_back(
        std::make_shared<const PartTemplate>(parse_template(part_template.dump(), name)));
  const Json active = json.value("active", Json(0));
  if (active.is_number_unsigned() && active.get<std::size_t>() < document.templates.size())
    document.active = active.get<std::size_t>();
  return document;
}

}  // namespace archetype
