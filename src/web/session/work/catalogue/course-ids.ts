import { missionId, missionRobots } from '#catalogue/mission-place';

const folders = import.meta.glob('../../../../../courses/*/course.json', { query: '?raw' });
const missions = import.meta.glob('../../../../../courses/missions/*/mission.json', { query: '?raw' });
const namesIn = (files: Readonly<Record<string, unknown>>): string[] =>
  Object.keys(files).flatMap((path) => path.split('/').slice(-2, -1));

/** Ids of the ready courses, without the courses themselves, which are loaded later. */
export const courseIds: readonly string[] = [
  ...namesIn(folders),
  ...namesIn(missions).flatMap((name) => missionRobots.map((robot) => missionId(name.replace(/^\d+-/, ''), robot))),
];
