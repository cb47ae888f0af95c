// Linked into every test of the window: what Qt itself keeps of the user (the folder that a file dialog
// showed last, say) goes to a folder of the test's own, from before the application begins until after it has
// ended.

#include <QByteArray>
#include <QDir>
#include <QStandardPaths>
#include <QTemporaryDir>

namespace {

class ScratchHome {
public:
    ScratchHome() {
        for (const char* name : {"XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_CACHE_HOME", "XDG_STATE_HOME"})
            qputenv(name, m_folder.filePath(QLatin1String(name).toString().toLower()).toLocal8Bit());
    }

private:
    QTemporaryDir m_folder;
};

const ScratchHome kHome;

} // namespace
