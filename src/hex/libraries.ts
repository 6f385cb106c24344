import { freeLibraries } from '#libraries/index';
import { findRobot, robotTypes } from '#robots/index';

/** Python sources by path. Runs get them together with the robots' behaviour, which is not needed here. */
const sources = import.meta.glob<string>('../robots/*/library/*.py', {
  query: '?raw',
  import: 'default',
  eager: true,
});

/** The sources of one robot, by file name. */
export function robotOwnLibraries(robot: string): Readonly<Record<string, string>> {
  const found: Record<string, string> = {};
  for (const [path, text] of Object.entries(sources)) {
    const [, id, name] = /\/([^/]+)\/library\/([^/]+)$/.exec(path) ?? [];
    if (id === robot && name !== undefined) found[name] = text;
  }
  for (const [name, same] of Object.entries(findRobot(robot)?.sameModules ?? {}))
    found[`${name}.py`] = found[`${same}.py`] ?? '';
  return found;
}

/**
 * Every library that a program may import, by file name. Those of the chosen robot win, as in a run.
 *
 * @param robot id of the robot, or `null` for the bare board
 */
export function allLibraries(robot: string | null): Readonly<Record<string, string>> {
  const all: Record<string, string> = { ...freeLibraries };
  for (const { id } of robotTypes) Object.assign(all, robotOwnLibraries(id));
  return Object.assign(all, robot === null ? {} : robotOwnLibraries(robot));
}
