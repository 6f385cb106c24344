import type { Language } from '#core/languages';
import { inEvery } from '#core/words';
import type { Scene } from '#scene/scene';

import type { Course } from './course';
import type { ProgramWords } from './read-courses';
import { missionId, missionRobots, type Mission, type MissionRobot } from './mission-place';

/** The library that a mission's programs import. */
const modules: Readonly<Record<MissionRobot, string>> = {
  'maqueen-lite': 'mbrobot',
  'maqueen-plus-v2': 'mbrobot_plusV2',
  'maqueen-plus-v3': 'mbrobot_plusV3',
  callibot: 'callibot',
};

/** A course of the ladder. */
export type MissionCourse = Course & { readonly mission: Mission };

/** The files of some missions, by their paths. */
export interface MissionFiles {
  /** `scene.json`, read. */
  readonly scenes: Readonly<Record<string, Scene>>;
  /** `mission.json`. */
  readonly data: Readonly<Record<string, string>>;
  /** `main.py`, with the texts about the mission. */
  readonly main: Readonly<Record<string, ProgramWords>>;
  /** `start.py`. */
  readonly start: Readonly<Record<string, ProgramWords['source']>>;
}

/** `mission.json`, see `missions.ts`. */
interface MissionData {
  readonly new: string;
  readonly robots: Readonly<
    Partial<
      Record<
        MissionRobot,
        { readonly stars: readonly [number, number]; readonly values?: Readonly<Record<string, number>> }
      >
    >
  >;
}

/** The missions in these files: for each robot the whole ladder, in its order. */
export function missionsOf(files: MissionFiles): readonly MissionCourse[] {
  const folders = Object.keys(files.main)
    .map((path) => path.replace('/main.py', ''))
    .sort();
  return missionRobots.flatMap((robot) => folders.flatMap((folder) => readMission(folder, robot, files)));
}

function readMission(
  folder: string,
  robot: MissionRobot,
  { scenes, data, main, start }: MissionFiles,
): MissionCourse[] {
  const read = scenes[`${folder}/scene.json`];
  const words = main[`${folder}/main.py`];
  const [, digits = '', name = ''] = /(\d+)-([^/]*)$/.exec(folder) ?? [];
  if (read === undefined || words === undefined || digits === '') return [];
  const facts = JSON.parse(data[`${folder}/mission.json`] ?? '') as MissionData;
  const own = facts.robots[robot];
  if (own === undefined) return []; // a mission for other robots
  const { stars, values = {} } = own;
  const filled = (program: ProgramWords['source']) =>
    inEvery((language: Language) => withValues(program[language], { module: modules[robot], ...values }));
  // Which robot drives is said by what the program imports, as in every course.
  const scene: Scene = { ...read, task: { ...read.task, stars } };
  return [
    {
      id: missionId(name, robot),
      place: null,
      level: 1,
      kind: 'drive',
      scene,
      program: filled(start[`${folder}/start.py`] ?? words.source),
      solution: filled(words.source),
      texts: inEvery((language) => ({
        name: words.name?.[language] ?? scene.name,
        text: words.text?.[language] ?? scene.description,
        task: words.task?.[language] ?? scene.description,
        hints: words.hints?.[language] ?? [],
      })),
      isRandom: false,
      devices: [],
      mission: { name, number: Number(digits), robot, news: facts.new },
    },
  ];
}

/** A program with the values of its robot at their places: `$drive` becomes 2000. */
const withValues = (program: string, values: Readonly<Record<string, number | string>>): string =>
  program.replace(/\$([a-zA-Z]\w*)/g, (place, name: string) => String(values[name] ?? place));
