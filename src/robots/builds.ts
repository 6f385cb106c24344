// Written by `npm run robots`: do not edit.
import { bitbotXlBuild } from './bitbot-xl/robot';
import { callibotBuild } from './callibot/robot';
import { cutebotBuild } from './cutebot/robot';
import { maqueenLiteBuild } from './maqueen-lite/robot';
import { maqueenPlusV1Build } from './maqueen-plus-v1/robot';
import { maqueenPlusV2Build } from './maqueen-plus-v2/robot';
import { maqueenPlusV3Build } from './maqueen-plus-v3/robot';
import { motionkit2Build } from './motionkit-2/robot';
import type { RobotBuild } from './robot';

/** The parts of every robot that a run needs. Apart from `index.ts`, as only a run loads them. */
export const robotBuilds: readonly RobotBuild[] = [
  bitbotXlBuild,
  callibotBuild,
  cutebotBuild,
  maqueenLiteBuild,
  maqueenPlusV1Build,
  maqueenPlusV2Build,
  maqueenPlusV3Build,
  motionkit2Build,
];
