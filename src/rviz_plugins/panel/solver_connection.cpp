#include <rviz_plugins/panel/solver_connection.h>

#include <utility>

#include <QMetaObject>

namespace cable_variation_rviz {

SolverConnection::SolverConnection(std::string solver, QObject* parent)
    : QObject(parent), solver_(std::move(solver)), spinner_(1, &queue_) {
  node_.setCallbackQueue(&queue_);
  spinner_.start();
}

SolverConnection::~SolverConnection() { spinner_.stop(); }

void SolverConnection::toQt(std::function<void()> task) {
  QMetaObject::invokeMethod(this, std::move(task), Qt::QueuedConnection);
}

}  // namespace cable_variation_rviz
