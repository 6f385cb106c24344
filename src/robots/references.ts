// Written by `npm run robots`: do not edit.
import type { RobotReference } from '#reference/types';
import { bitbotXlReference } from './bitbot-xl/reference';
import { callibotReference } from './callibot/reference';
import { cutebotReference } from './cutebot/reference';
import { maqueenLiteReference } from './maqueen-lite/reference';
import { maqueenPlusV1Reference } from './maqueen-plus-v1/reference';
import { maqueenPlusV2Reference } from './maqueen-plus-v2/reference';
import { maqueenPlusV3Reference } from './maqueen-plus-v3/reference';
import { motionkit2Reference } from './motionkit-2/reference';

/** The libraries of robots, for the editor. Apart from `index.ts`, as only the editor loads them, and later. */
export const robotReferences: readonly RobotReference[] = [
  bitbotXlReference,
  callibotReference,
  cutebotReference,
  maqueenLiteReference,
  maqueenPlusV1Reference,
  maqueenPlusV2Reference,
  maqueenPlusV3Reference,
  motionkit2Reference,
];
