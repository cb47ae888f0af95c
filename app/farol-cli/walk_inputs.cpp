#include "app/farol-cli/walk_inputs.h"

#include "app/farol-cli/output.h"
#include "core/building/geopackage.h"
#include "ui/speech/phrasebook.h"

#include <filesystem>
#include <utility>

namespace farol::cli {

std::shared_ptr<const building::Building> openMap(const std::string& path, int& exitCode) {
    auto loaded = building::loadBuilding(path);
    if (!loaded) {
        exitCode = report(loaded.error());
        return nullptr;
    }
    warnAll(loaded->warnings);
    return loaded->building;
}

bool findPlace(const building::Building& building, const std::string& option, const std::string& where,
               std::optional<building::Location>& place, int& exitCode) {
    if (where.empty()) return true;
    auto found = building::resolveWhere(building, where);
    if (!found) {
        Error error = found.error();
        error.context = option + " " + where;
        report(error);
        exitCode = kUsage;
        return false;
    }
    place = std::move(found).value();
    return true;
}

bool openLibrary(const std::string& path, const std::string& map,
                 std::shared_ptr<const recognition::LandmarkLibrary>& library, int& exitCode) {
    std::error_code ignored;
    bool given = !path.empty() && std::filesystem::exists(path, ignored);
    if (!path.empty() && !given) warn(path + ": there is no such library; the map's own file is tried");
    auto loaded = recognition::loadLibrary(given ? path : map);
    if (loaded) {
        library = std::make_shared<const recognition::LandmarkLibrary>(std::move(loaded).value());
        return true;
    }
    ErrorCode code = loaded.error().code;
    if (!given && (code == ErrorCode::NotFound || code == ErrorCode::UnsupportedFormat)) return true;
    exitCode = reportLibrary(loaded.error(), given ? path : map);
    return false;
}

void chooseLanguage(const std::string& language) {
    if (!ui::installTranslation(QString::fromStdString(language)))
        warn("there is no translation for \"" + language + "\"; English is used");
}

} // namespace farol::cli
