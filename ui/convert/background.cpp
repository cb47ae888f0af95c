#include "ui/convert/background.h"

namespace farol::ui {

void Doorway::post(std::function<void()> call) {
    const std::scoped_lock lock(m_mutex);
    if (m_target) QMetaObject::invokeMethod(m_target, std::move(call), Qt::QueuedConnection);
}

void Doorway::detach() {
    const std::scoped_lock lock(m_mutex);
    m_target = nullptr;
}

Background::Background(QObject* target) : m_doorway(std::make_shared<Doorway>(target)) {
    m_pool.setMaxThreadCount(4); // a camera that answers late must not keep a map waiting
}

Background::~Background() {
    m_doorway->detach();
    m_pool.waitForDone();
}

} // namespace farol::ui
