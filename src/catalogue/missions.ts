/**
 * The missions: a ladder of small courses for beginners, each with one new thing. Each is a folder in `courses/missions/`,
 * named by its number and its name. It is there for the robots that it names; where one needs a mission of its own, two
 * folders have the same number and each robot is named in one of them:
 *
 * - `scene.json`: the course, the same for each of these robots.
 * - `mission.json`: `{ "new": "forward()", "robots": { "callibot": { "stars": [9, 6], "values": { "drive": 1700 } }, … } }`: the
 *   piece of Python that it brings, and for each of its robots the times (s) for two and three stars and what its programs need.
 * - `main.py`: the program that solves it, in English. `$drive` is replaced by the robot's value of that name,
 *   `$module` by its library.
 * - `start.py`: the program on opening it.
 * - `words/de.json`, …: as those of a course (`courses.ts`), and `hints`.
 *
 * The page loads this on demand, with the list; its `first-course.ts` holds the one that is part of the page.
 */
import { missionsOf, type MissionCourse, type MissionFiles } from './mission';
import type { Mission, MissionRobot } from './mission-place';

const files: MissionFiles = {
  scenes: import.meta.glob('../../courses/missions/*/scene.json', {
    query: '?scene',
    import: 'default',
    eager: true,
  }),
  data: import.meta.glob('../../courses/missions/*/mission.json', {
    query: '?raw',
    import: 'default',
    eager: true,
  }),
  main: import.meta.glob('../../courses/missions/*/main.py', {
    query: '?languages',
    import: 'default',
    eager: true,
  }),
  start: import.meta.glob('../../courses/missions/*/start.py', {
    query: '?languages',
    import: 'source',
    eager: true,
  }),
};

/** All missions: for each robot the whole ladder, in its order. */
export const missions: readonly MissionCourse[] = missionsOf(files);

/** The ladder of a robot. */
export const ladderOf = (robot: MissionRobot): readonly MissionCourse[] =>
  missions.filter(({ mission }) => mission.robot === robot);

/** The mission after another one for the same robot; `null` after the last. */
export const missionAfter = ({ robot, number }: Mission): MissionCourse | null =>
  ladderOf(robot).find(({ mission }) => mission.number === number + 1) ?? null;
