import { freeReference } from '#libraries/reference';
import { robotReferences } from '#robots/references';

import type { Written } from '../../../session/work/hardware/written-for';
import type { RobotModules } from './import-line';

/** The modules of the robot that a program is written for, and those of all robots. */
export function robotModules({ hardware }: Written): RobotModules {
  const robot = hardware?.robot?.id ?? null;
  const own = robotReferences.find((it) => it.robot === robot)?.modules.map(({ name }) => name) ?? [];
  const all = new Set([...robotReferences, freeReference].flatMap(({ modules }) => modules.map((it) => it.name)));
  return { own, all };
}
