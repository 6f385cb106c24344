import { freeLibraries } from '#libraries/index';
import { robotBuilds } from '#robots/builds';
import type { RobotBuild } from '#robots/robot';

/** The parts of the robot with this id that a run needs, or `null`. */
export function findBuild(id: string): RobotBuild | null {
  return robotBuilds.find(({ type }) => type.id === id) ?? null;
}

/**
 * The Python modules on the board, by file name. Those of the chosen robot win. Modules of other robots and of no robot
 * are there too, as their files would be on a real board that carries another robot or none.
 *
 * @param id the chosen robot, or `null` for the bare board
 */
export function robotLibraries(id: string | null): Readonly<Record<string, string>> {
  const libraries: Record<string, string> = { ...freeLibraries };
  for (const build of robotBuilds) Object.assign(libraries, build.libraries);
  return Object.assign(libraries, id === null ? {} : findBuild(id)?.libraries);
}
