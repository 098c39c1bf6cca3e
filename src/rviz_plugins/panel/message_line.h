#pragma once

#include <vector>

#include <QFrame>
#include <QString>

class QLabel;
class QScrollArea;

namespace cable_variation_rviz {

/// What went wrong, where the person looks: red, to be selected and copied, there until what went wrong goes
/// well or it is closed. As high as its text, up to a few lines, then it scrolls. Also for what went well.
/// Each thing that is asked for, such as "load", has at most one message: a newer one takes the place of its
/// older one, and leaves those of others, of which the newest is on top.
class MessageLine : public QFrame {
  Q_OBJECT

 public:
  explicit MessageLine(QWidget* parent = nullptr);

  void showError(const QString& of, const QString& text);
  void showNote(const QString& of, const QString& text);
  void clear(const QString& of);  ///< it has gone well
  void clearAll();                ///< hides it
  QString text() const;
  bool isError() const;  ///< one of them at least

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  struct Message {
    QString of, text;
    bool error;
  };
  void add(const Message& message);
  void remove(const QString& of);
  void show();
  void fit();

  QScrollArea* area_;
  QLabel* label_;
  std::vector<Message> messages_;  ///< the newest first
};

}  // namespace cable_variation_rviz
