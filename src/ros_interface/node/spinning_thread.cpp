#include <ros_interface/node/spinning_thread.h>

#include <condition_variable>
#include <exception>
#include <mutex>

#include <ros/callback_queue_interface.h>

namespace cable_variation_ros {

struct SpinningThread::Shared {
  std::mutex mutex;
  std::condition_variable changed;
  bool stopped = false;
};

namespace {

/// One task, called from the queue as callbacks are.
template <typename Shared>
class Call : public ros::CallbackInterface {
 public:
  Call(std::shared_ptr<Shared> shared, const std::function<void()>& task)
      : shared_(std::move(shared)), task_(task) {}

  CallResult call() override {
    {
      const std::lock_guard<std::mutex> lock(shared_->mutex);
      if (shared_->stopped) return Success;  // whoever waited has gone, and the task with it
    }
    try {
      task_();
    } catch (...) {
      error_ = std::current_exception();
    }
    const std::lock_guard<std::mutex> lock(shared_->mutex);
    done_ = true;
    shared_->changed.notify_all();
    return Success;
  }

  void wait() {
    std::unique_lock<std::mutex> lock(shared_->mutex);
    shared_->changed.wait(lock, [&] { return done_ || shared_->stopped; });
    if (!done_) throw NodeEnds();
    if (error_) std::rethrow_exception(error_);
  }

 private:
  std::shared_ptr<Shared> shared_;
  const std::function<void()>& task_;
  std::exception_ptr error_;
  bool done_ = false;
};

}  // namespace

SpinningThread::SpinningThread(ros::CallbackQueueInterface& queue)
    : queue_(queue), shared_(std::make_shared<Shared>()) {}

void SpinningThread::run(const std::function<void()>& task) {
  if (stopped()) throw NodeEnds();
  const auto call = boost::make_shared<Call<Shared>>(shared_, task);
  queue_.addCallback(call);
  call->wait();
}

void SpinningThread::stop() {
  const std::lock_guard<std::mutex> lock(shared_->mutex);
  shared_->stopped = true;
  shared_->changed.notify_all();
}

bool SpinningThread::stopped() const {
  const std::lock_guard<std::mutex> lock(shared_->mutex);
  return shared_->stopped;
}

}  // namespace cable_variation_ros
