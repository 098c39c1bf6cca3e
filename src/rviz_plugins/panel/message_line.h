#pragma once

#include <QFrame>

class QLabel;
class QScrollArea;

namespace cable_variation_rviz {

/// What went wrong, where the person looks: red, to be selected and copied, there until the next thing goes
/// well or it is closed. As high as its text, up to a few lines, then it scrolls. Also for what went well.
class MessageLine : public QFrame {
  Q_OBJECT

 public:
  explicit MessageLine(QWidget* parent = nullptr);

  void showError(const QString& text);
  void showNote(const QString& text);
  void clear();  ///< hides it
  QString text() const;
  bool isError() const { return error_; }

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void show(const QString& text, bool error);
  void fit();

  QScrollArea* area_;
  QLabel* label_;
  bool error_ = false;
};

}  // namespace cable_variation_rviz
