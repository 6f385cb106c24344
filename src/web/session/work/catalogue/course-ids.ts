import { missionId, missionRobots, type MissionRobot } from '#catalogue/mission-place';

// Inside of Object.keys the bundle has the names alone, without a way to load each file.
const folders = Object.keys(import.meta.glob('../../../../../courses/*/course.json', { query: '?raw' }));
/** Only `robots` of each `mission.json`: short, so that the ids come with the page. */
const missions = import.meta.glob<Partial<Readonly<Record<MissionRobot, unknown>>>>(
  '../../../../../courses/missions/*/mission.json',
  { import: 'robots', eager: true },
);
const folderOf = (path: string): string => path.split('/').at(-2) ?? '';

/** Ids of the ready courses, without the courses themselves, which are loaded later. */
export const courseIds: readonly string[] = [
  ...folders.map(folderOf),
  ...Object.entries(missions).flatMap(([path, robots]) =>
    missionRobots
      .filter((robot) => robots[robot] !== undefined)
      .map((robot) => missionId(folderOf(path).replace(/^\d+-/, ''), robot)),
  ),
];
