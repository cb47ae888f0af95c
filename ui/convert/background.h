#pragma once
// Work off the GUI thread whose result comes back to it.

#include <QMetaObject>
#include <QObject>
#include <QThreadPool>

#include <functional>
#include <memory>
#include <mutex>

namespace farol::ui {

/// A door to a GUI object for other threads: once detached, or once the object is gone, what is posted is
/// dropped.
class Doorway {
public:
    explicit Doorway(QObject* target) : m_target(target) {}

    void post(std::function<void()> call);
    void detach();

private:
    std::mutex m_mutex;
    QObject* m_target;
};

/// Runs jobs on threads of its own. The destructor waits for the running ones and drops their results.
class Background {
public:
    explicit Background(QObject* target);
    ~Background();
    Background(const Background&) = delete;
    Background& operator=(const Background&) = delete;

    const std::shared_ptr<Doorway>& doorway() const { return m_doorway; }

    /// `done` runs on the GUI thread with what `work` returned.
    template <class Work, class Done>
    void run(Work work, Done done) {
        m_pool.start([doorway = m_doorway, work = std::move(work), done = std::move(done)]() mutable {
            auto result = std::make_shared<decltype(work())>(work());
            doorway->post([result, done]() mutable { done(std::move(*result)); });
        });
    }
    void run(std::function<void()> work) { m_pool.start(std::move(work)); }

private:
    std::shared_ptr<Doorway> m_doorway;
    QThreadPool m_pool;
};

} // namespace farol::ui
