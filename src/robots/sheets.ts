// Written by `npm run robots`: do not edit.
import { bitbotXlSheet } from './bitbot-xl/sheet';
import { callibotSheet } from './callibot/sheet';
import { cutebotSheet } from './cutebot/sheet';
import { maqueenLiteSheet } from './maqueen-lite/sheet';
import { maqueenPlusV1Sheet } from './maqueen-plus-v1/sheet';
import { maqueenPlusV2Sheet } from './maqueen-plus-v2/sheet';
import { maqueenPlusV3Sheet } from './maqueen-plus-v3/sheet';
import { motionkit2Sheet } from './motionkit-2/sheet';
import type { RobotSheet } from './robot';

/** The texts of the gallery on every robot. Apart from `index.ts`, as only the gallery loads them, and later. */
export const robotSheets: readonly RobotSheet[] = [
  bitbotXlSheet,
  callibotSheet,
  cutebotSheet,
  maqueenLiteSheet,
  maqueenPlusV1Sheet,
  maqueenPlusV2Sheet,
  maqueenPlusV3Sheet,
  motionkit2Sheet,
];
