import { freeLibraries } from '#libraries/index';
import { robotBuilds } from '#robots/builds';
import type { RobotBuild } from '#robots/robot';

/** What a run needs of the robot with this id, or `null`. */
export function findBuild(id: string): RobotBuild | null {
  return robotBuilds.find(({ type }) => type.id === id) ?? null;
}

/**
 * Python modules that come along, by file name. Those of the chosen robot win, those of the others and those that belong
 * to no robot are there too, as their files would be on a real board that carries another robot, or none.
 *
 * @param id the chosen robot, or `null` for the bare board
 */
export function robotLibraries(id: string | null): Readonly<Record<string, string>> {
  const libraries: Record<string, string> = { ...freeLibraries };
  for (const build of robotBuilds) Object.assign(libraries, build.libraries);
  return Object.assign(libraries, id === null ? {} : findBuild(id)?.libraries);
}
