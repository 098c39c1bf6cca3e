#include <rviz_plugins/panel/slider_delegate.h>

#include <cmath>

#include <QEvent>
#include <QSignalBlocker>
#include <QSlider>

#include <rviz_plugins/panel/variable_table_model.h>

namespace cable_variation_rviz {

namespace {

constexpr int kSteps = 200;  // of a slider: finer than its pixels, and the middle is one of them

}  // namespace

QWidget* SliderDelegate::createEditor(QWidget* parent, const QStyleOptionViewItem&,
                                      const QModelIndex&) const {
  auto* slider = new QSlider(Qt::Horizontal, parent);
  slider->setRange(0, kSteps);
  slider->setPageStep(kSteps / 10);
  slider->setTickPosition(QSlider::TicksBelow);
  slider->setTickInterval(kSteps / 2);  // the limits and the middle
  slider->setFocusPolicy(Qt::StrongFocus);
  slider->setAutoFillBackground(true);
  connect(slider, &QSlider::valueChanged, this,
          [this, slider] { Q_EMIT const_cast<SliderDelegate*>(this)->commitData(slider); });
  return slider;
}

void SliderDelegate::setEditorData(QWidget* editor, const QModelIndex& index) const {
  auto* slider = static_cast<QSlider*>(editor);
  if (slider->isSliderDown()) return;  // it follows the hand that holds it
  const QSignalBlocker quiet(slider);
  slider->setValue(static_cast<int>(std::lround(kSteps * index.data(VariableTableModel::kShare).toDouble())));
}

void SliderDelegate::setModelData(QWidget* editor, QAbstractItemModel* model,
                                  const QModelIndex& index) const {
  model->setData(index, static_cast<double>(static_cast<QSlider*>(editor)->value()) / kSteps);
}

void SliderDelegate::updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                                          const QModelIndex&) const {
  editor->setGeometry(option.rect.adjusted(4, 2, -4, -2));
}

bool SliderDelegate::eventFilter(QObject* editor, QEvent* event) {
  // A table that is scrolled must not change the design.
  if (event->type() == QEvent::Wheel) {
    event->ignore();
    return true;
  }
  return QObject::eventFilter(editor,
                              event);  // not the delegate's own: Escape and Tab would close the slider
}

}  // namespace cable_variation_rviz
