import type { Texts } from '#core/languages';

import panelWords from '../../../pupil/board/panels/words';
import { t } from '../../../kit/i18n';
import makerWords from '../words';
import type { InputKind } from './world-inputs';

const words = makerWords.more;
const gestures: Readonly<Record<string, Texts>> = {
  shake: panelWords.sensors.shake,
  up: panelWords.sensors.gestureUp,
  down: panelWords.sensors.gestureDown,
  left: panelWords.sensors.gestureLeft,
  right: panelWords.sensors.gestureRight,
  'face up': panelWords.sensors.gestureFaceUp,
  'face down': panelWords.sensors.gestureFaceDown,
  freefall: panelWords.sensors.gestureFreefall,
};

/** Name of a sensor. */
export function sensorName(id: string): string {
  if (id.startsWith('accelerometer')) return t('sensors.accelerometer', { axis: id.slice(-1) });
  switch (id) {
    case 'lightLevel':
    case 'soundLevel':
    case 'temperature':
    case 'compassHeading':
      return t(`sensors.${id}`);
    default:
      return id;
  }
}

/** Name of an event; of a gesture which one, if it is given. */
export function inputName(kind: InputKind, gesture?: string): string {
  const [type, name = ''] = kind.split(' ');
  switch (type) {
    case 'button':
      return t(words.button, { name: name.toUpperCase() });
    case 'touch':
      return name === 'pinLogo' ? t('board.logo') : `P${name.slice(-1)}`;
    case 'gesture': {
      if (gesture === undefined) return t(words.gesture);
      const told = gestures[gesture];
      return told === undefined ? gesture : t(told);
    }
    case 'radio':
      return t(words.radio);
    case 'serial':
      return t(words.serial);
    default:
      return sensorName(name);
  }
}
