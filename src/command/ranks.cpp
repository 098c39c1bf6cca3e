#include <command/ranks.h>

#include <algorithm>
#include <chrono>
#include <new>
#include <stdexcept>
#include <thread>
#include <utility>

#include <cable_variation/util/byte_stream.h>
#include <cable_variation/util/error.h>
#include <command/rank_pool.h>

namespace cable_variation_command {

using cable_variation::BlockDealer;
using cable_variation::BlockRange;
using cable_variation::ByteReader;
using cable_variation::ByteWriter;
using cable_variation::ErrorKind;
using cable_variation::SimulationIdentity;

namespace {

// Blocks that a thread elsewhere has at hand: one is solved while the next is on its way.
constexpr std::size_t kAtHand = 2;
// Between two looks whether something has arrived: little against the time of a block, and no load.
constexpr std::chrono::microseconds kLook(200);
// The helpers have so long to end: that of a few blocks; when all of it is cancelled, the launcher is about
// to kill whoever is left.
constexpr std::chrono::seconds kEnd(20);
constexpr std::chrono::milliseconds kCancelledEnd(300);

void wait() { std::this_thread::sleep_for(kLook); }

std::string withRange(const BlockRange& range, const std::string& bytes) {
  ByteWriter message;
  message.write<std::uint64_t>(range.first);
  message.write<std::uint64_t>(range.count);
  return message.take() + bytes;
}

BlockRange rangeIn(ByteReader& reader) {
  BlockRange range;
  range.first = reader.read<std::uint64_t>();
  range.count = reader.read<std::uint64_t>();
  return range;
}

}  // namespace

std::unique_ptr<Ranks> Ranks::join(std::uint64_t threads, cable_variation::RunControl& control) {
  std::unique_ptr<RankLink> link = linkOfRanks();
  return link ? std::make_unique<Ranks>(std::move(link), threads, control) : nullptr;
}

Ranks::Ranks(std::unique_ptr<RankLink> link, std::uint64_t threads, cable_variation::RunControl& control)
    : link_(std::move(link)), threads_(std::thread::hardware_concurrency()), control_(control) {
  threads_ = std::max<std::uint64_t>(1, threads == 0 ? threads_ : std::min(threads, threads_));
  hosts_.resize(static_cast<std::size_t>(link_->size()), link_->host());
  free_.resize(static_cast<std::size_t>(link_->size()), 0);
}

bool Ranks::receive(Message& message) {
  if (!link_->receive(message.from, message.kind, message.bytes)) return false;
  stopped_ = stopped_ || message.kind == RankMessage::stop;
  byes_ += message.kind == RankMessage::bye ? 1 : 0;
  return true;
}

void Ranks::throwOf(const Message& message) const {
  ByteReader reader(message.bytes);
  const auto kind = static_cast<ErrorKind>(reader.read<std::uint8_t>());
  const std::string text = "rank " + std::to_string(message.from) + " on " +
                           hosts_[static_cast<std::size_t>(message.from)] + ": " +
                           std::string(reader.take(reader.left()));
  if (kind == ErrorKind::invalid_input) throw std::invalid_argument(text);
  if (kind == ErrorKind::not_found) throw cable_variation::NotFound(text);
  if (kind == ErrorKind::file_error) throw cable_variation::FileError(text);
  if (kind == ErrorKind::cancelled) throw cable_variation::Cancelled(text);
  if (kind == ErrorKind::not_converged) throw cable_variation::NotConverged(text);
  throw cable_variation::InternalError(text);
}

void Ranks::agree(const SimulationIdentity& identity) {
  if (isHelper()) {
    agreeAsHelper(identity);
  } else {
    agreeAsFirst(identity);
  }
}

void Ranks::agreeAsHelper(const SimulationIdentity& identity) {
  ByteWriter about;
  about.write(threads_);
  link_->send(
      0, RankMessage::identity,
      about.take() + cable_variation::toText({{"host", link_->host()}}) + cable_variation::toText(identity));
  for (Message message;;) {
    if (!receive(message)) {
      wait();
    } else if (message.kind == RankMessage::agreed) {
      return;
    } else if (stopped_) {
      throw cable_variation::Cancelled();
    }
  }
}

void Ranks::agreeAsFirst(const SimulationIdentity& identity) {
  std::string differences;
  for (int missing = link_->size() - 1; missing > 0;) {
    Message message;
    if (!receive(message)) {
      control_.throwIfCancelled();
      wait();
      continue;
    }
    if (message.kind == RankMessage::failed) throwOf(message);
    ByteReader reader(message.bytes);
    elsewhere_ += 2 * kAtHand * reader.read<std::uint64_t>();
    SimulationIdentity other = cable_variation::identityFrom(std::string(reader.take(reader.left())));
    std::string& host = hosts_[static_cast<std::size_t>(message.from)];
    host = other.front().second;
    other.erase(other.begin());
    const std::string difference = cable_variation::differenceOf(identity, "on rank 0", other, "there");
    if (!difference.empty()) {
      differences += (differences.empty() ? "" : "; ") + ("rank " + std::to_string(message.from)) + " on " +
                     host + ": " + difference;
    }
    --missing;
  }
  if (!differences.empty())
    throw std::invalid_argument("ranks would simulate different things: " + differences +
                                "; expected the same scene, options, program and kind of machine on all");
  for (int rank = 1; rank < link_->size(); ++rank) link_->send(rank, RankMessage::agreed, "");
}

std::string Ranks::solvedBefore(const BlockRange& range) {
  return kept_ == nullptr ? "" : kept_->solvedBefore(range);
}

void Ranks::keep(const BlockRange& range, const std::string& bytes) {
  if (kept_ != nullptr) kept_->keep(range, bytes);
}

void Ranks::take(const Message& message, BlockDealer& dealer) {
  const auto from = static_cast<std::size_t>(message.from);
  if (message.kind == RankMessage::failed) throwOf(message);
  ByteReader reader(message.bytes);
  if (message.kind == RankMessage::ready) {
    free_[from] = kAtHand * reader.read<std::uint64_t>();
  } else if (message.kind == RankMessage::block) {
    const BlockRange range = rangeIn(reader);
    dealer.deliver(range, std::string(reader.take(reader.left())));
    ++free_[from];
  }
}

bool Ranks::dealTo(int rank, BlockDealer& dealer) {
  std::size_t& room = free_[static_cast<std::size_t>(rank)];
  BlockRange range;
  if (room == 0 || !dealer.next(range)) return false;
  std::string bytes = solvedBefore(range);
  if (!bytes.empty()) {
    dealer.deliver(range, std::move(bytes));
  } else {
    link_->send(rank, RankMessage::block, withRange(range, ""));
    --room;
  }
  return true;
}

void Ranks::deal(BlockDealer& dealer) {
  while (!dealer.ended()) {
    bool idle = true;
    for (Message message; receive(message); idle = false) take(message, dealer);
    for (int rank = 1; rank < link_->size(); ++rank) idle = !dealTo(rank, dealer) && idle;
    if (idle) wait();
  }
}

void Ranks::help(std::size_t threads, const std::function<cable_variation::BlockSolver()>& make) {
  RankPool pool(threads, make);
  ByteWriter count;
  count.write<std::uint64_t>(threads);
  link_->send(0, RankMessage::ready, count.take());
  while (!stopped_) {
    bool idle = true;
    for (Message message; receive(message); idle = false) {
      if (message.kind != RankMessage::block) continue;
      ByteReader reader(message.bytes);
      pool.add(rangeIn(reader));
    }
    for (RankPool::Solved solved; pool.take(solved); idle = false)
      link_->send(0, RankMessage::block, withRange(solved.range, solved.bytes));
    pool.throwFailure();
    if (idle) wait();
  }
}

void Ranks::leave() {
  if (std::exchange(left_, true)) return;
  if (isHelper()) {
    for (Message message; !stopped_;) {
      if (!receive(message)) wait();
    }
    link_->send(0, RankMessage::bye, "");
    while (!link_->sent()) wait();
    link_->finish();
    return;
  }
  for (int rank = 1; rank < link_->size(); ++rank) link_->send(rank, RankMessage::stop, "");
  const auto start = std::chrono::steady_clock::now();
  const auto most = control_.cancelled() ? std::chrono::milliseconds(kCancelledEnd) : kEnd;
  while (byes_ < link_->size() - 1 || !link_->sent()) {
    Message message;
    if (receive(message)) continue;
    if (std::chrono::steady_clock::now() - start > most) return;  // the launcher ends who is left
    wait();
  }
  link_->finish();
}

Answer Ranks::quiet() {
  leave();
  Answer answer;
  answer.quiet = true;
  return answer;
}

Answer Ranks::failed(const std::exception& error) {
  if (!stopped_) {
    ByteWriter kind;
    kind.write(static_cast<std::uint8_t>(cable_variation::kindOf(error)));
    link_->send(0, RankMessage::failed, kind.take() + error.what());
  }
  return quiet();
}

}  // namespace cable_variation_command
