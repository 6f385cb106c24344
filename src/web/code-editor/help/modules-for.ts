import { freeReference } from '#libraries/reference';
import type { RobotReference } from '#reference/types';
import { robotReferences } from '#robots/references';

/** All libraries, those of the chosen robot first: where two have the same name, its own counts. */
export function modulesFor(robot: string | null): RobotReference['modules'] {
  const isChosen = (it: RobotReference): boolean => it.robot === robot;
  const others = robotReferences.filter((it) => !isChosen(it));
  return [...robotReferences.filter(isChosen), ...others, freeReference].flatMap(({ modules }) => modules);
}
