#include "core/session/place_json.h"

namespace farol::session {

void addLookAlikes(Json& json, const recognition::Detection& detection, Json (*number)(double)) {
    if (detection.strength > 0.0) json["strength"] = number(detection.strength);
    if (detection.lookAlikes.empty()) return;
    Json list = Json::array();
    for (const recognition::LookAlike& other : detection.lookAlikes)
        list.push_back({{"template", other.templateId.value}, {"strength", number(other.strength)}});
    json["look_alikes"] = std::move(list);
}

void readLookAlikes(JsonFields& fields, recognition::Detection& detection) {
    detection.strength = fields.numberOr("strength", 0.0);
    if (detection.strength < 0.0) fields.complain("\"strength\" is negative");
    if (!fields.has("look_alikes")) return;
    for (const Json& item : fields.array("look_alikes")) {
        JsonFields one(item);
        recognition::LookAlike other{TemplateId(one.text("template")), one.number("strength")};
        if (other.strength < 0.0) one.complain("\"strength\" is negative");
        if (!one.ok()) fields.complain("in \"look_alikes\": " + one.wrong());
        if (!fields.ok()) return;
        detection.lookAlikes.push_back(std::move(other));
    }
}

} // namespace farol::session
