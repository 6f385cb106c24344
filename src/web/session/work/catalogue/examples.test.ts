import { readFileSync } from 'node:fs';
import { beforeAll, describe, expect, it } from 'vitest';

import { optionProblem } from '#core/option';
import { filesByName, type Project } from '#project/project';
import { defaultScene, type Point, type Scene, type SceneObject } from '#scene/scene';
import { soloRun } from '#simulation/run-setup';
import { Simulation } from '#simulation/simulation';
import type { TraceRow } from '#simulation/trace';
import type { RobotSnapshot } from '#simulation/snapshot';
import { LANGUAGES } from '../../../kit/i18n/texts';
import { projectOf } from '#catalogue/course';
import { courses } from '#catalogue/courses';
import { examples, withExample, type ExampleOf } from './examples';

let firmware: WebAssembly.Module;
beforeAll(() => {
  firmware = new WebAssembly.Module(readFileSync('.cache/vm/vm.wasm'));
});

/** The project of a first visit. */
const found: Project = projectOf(
  courses.find(({ id }) => id === 'closed-line')!,
  'de',
);
const entryOf = (robot: string, file: string): ExampleOf =>
  examples.find((entry) => entry.robot.id === robot && entry.example.file === file)!;

/** Puts a robot where a project begins. */
function begin({ scene, files }: Project, robot: string): Promise<Simulation> {
  const setup = { scene, files: filesByName(files), robot, board: 'auto', seed: 1, reality: 0, keepTrace: true };
  return Simulation.create(soloRun(setup), firmware);
}

const robotOf = (simulation: Simulation): RobotSnapshot => simulation.snapshot().robot!;

const traces = new WeakMap<Simulation, TraceRow[]>();

/** All rows of a run so far. */
function traceOf(run: Simulation): readonly TraceRow[] {
  const rows = [...(traces.get(run) ?? []), ...run.takeTrace()];
  traces.set(run, rows);
  return rows;
}

/** Headings in degrees at which the robot drove straight on or stood for at least 0.1 s, one behind the other. */
function straightHeadings(run: Simulation): number[] {
  const trace = traceOf(run);
  const headings: number[] = [];
  let turned = 0;
  let steady = 0;
  trace.forEach(({ headingRad }, i) => {
    const by = ((headingRad - (trace[i - 1]?.headingRad ?? headingRad)) * 180) / Math.PI;
    const step = by - 360 * Math.round(by / 360);
    turned += step;
    steady = Math.abs(step) < 0.05 ? steady + 1 : 0;
    if (steady === 5) headings.push(turned);
  });
  return headings;
}

/** A fact about a run after a number of simulated ms. */
interface Moment {
  readonly afterMs: number;
  readonly says: string;
  readonly holds: (run: Simulation) => void;
}

const hasEnded: Moment['holds'] = (run) => expect(run.ended?.kind).toBe('finished');

const fourQuarters: Moment = {
  afterMs: 12_000,
  says: 'four quarter turns are 90° each, within 3°',
  holds(run) {
    const headings = straightHeadings(run);
    const turns = headings.slice(1, 5).map((heading, i) => heading - headings[i]!);
    expect(turns).toHaveLength(4);
    for (const turn of turns) expect(Math.abs(turn - 90)).toBeLessThan(3);
  },
};

const endsDark = (afterMs: number): Moment => ({
  afterMs,
  says: 'it ends with motors and lights off',
  holds(run) {
    hasEnded(run);
    const { duty, leds, rgb } = robotOf(run).state;
    expect([duty, leds]).toEqual([{ left: 0, right: 0 }, { left: 0, right: 0 }]); // prettier-ignore
    expect(rgb.flat().every((part) => part === 0)).toBe(true);
  },
});

const clawAt = (angleDeg: number, afterMs: number, withinDeg = 4.9): Moment => ({
  afterMs,
  says: `the claw is at ${angleDeg}°, within ${withinDeg}°`,
  holds(run) {
    const [claw] = robotOf(run).state.attachments;
    expect(claw?.type).toBe('claw');
    expect(Math.abs(claw!.angleDeg - angleDeg)).toBeLessThanOrEqual(withinDeg);
  },
});

const opensAndCloses = [clawAt(30, 900), clawAt(90, 1900)];
const opensInTheEnd = (withinDeg: number): Moment[] => [
  ...opensAndCloses,
  { afterMs: 12_000, says: 'it ends', holds: hasEnded },
  clawAt(35, 12_000, withinDeg),
];

/** The events that the examples show beyond driving without an exception. */
const STORIES: Readonly<Record<string, readonly Moment[]>> = {
  'maqueen-lite first_drive.py': [fourQuarters, endsDark(30_000)],
  'maqueen-lite lights.py': [endsDark(30_000)],
  'maqueen-lite square.py': [
    fourQuarters,
    {
      afterMs: 30_000,
      says: 'it has turned by 360° within 10° and is back within 10 cm',
      holds(run) {
        hasEnded(run);
        const { turnedRad, pose } = robotOf(run);
        expect(Math.abs((turnedRad * 180) / Math.PI - 360)).toBeLessThan(10);
        const [start] = traceOf(run);
        expect(Math.hypot(pose.xMm - start!.xMm, pose.yMm - start!.yMm)).toBeLessThan(100);
      },
    },
  ],
  'maqueen-lite servo.py': opensInTheEnd(0),
  'maqueen-plus-v1 first_drive.py': [fourQuarters],
  'maqueen-plus-v1 wheels.py': [
    {
      afterMs: 8000,
      says: 'it stops after half a metre, within 1.5 cm',
      holds(run) {
        hasEnded(run);
        expect(Math.abs(robotOf(run).pathMm - 500)).toBeLessThan(15);
      },
    },
  ],
  'maqueen-plus-v1 line.py': [
    {
      afterMs: 30_000,
      says: 'it has followed the line for 3.5 m and still sees it',
      holds(run) {
        const { pathMm, state } = robotOf(run);
        expect(pathMm).toBeGreaterThan(3500);
        expect(state.lineSensors.some(({ bright }) => !bright)).toBe(true);
      },
    },
  ],
  'maqueen-plus-v2 first_drive.py': [endsDark(20_000)],
  'maqueen-plus-v2 lights.py': [endsDark(20_000)],
  'maqueen-plus-v2 servo.py': opensInTheEnd(4.9),
  'maqueen-plus-v2 distance.py': [
    {
      afterMs: 30_000,
      says: 'it has driven 2 m about the arena and touched nothing',
      holds(run) {
        const { pathMm, collisions } = robotOf(run);
        expect(pathMm).toBeGreaterThan(2000);
        expect(collisions).toBe(0);
      },
    },
  ],
  'maqueen-plus-v3 first_drive.py': [endsDark(20_000)],
  'maqueen-plus-v3 lidar.py': [
    {
      afterMs: 60_000,
      says: 'it has driven 3 m about the arena and touched nothing',
      holds(run) {
        const { pathMm, collisions } = robotOf(run);
        expect(pathMm).toBeGreaterThan(3000);
        expect(collisions).toBe(0);
      },
    },
  ],
  'maqueen-plus-v3 patrol.py': [
    {
      afterMs: 13_000,
      says: 'it has followed the line for 1.4 m and still sees it',
      holds(run) {
        const { pathMm, state } = robotOf(run);
        expect(pathMm).toBeGreaterThan(1400);
        expect(state.lineSensors.some(({ bright }) => !bright)).toBe(true);
      },
    },
  ],
  'maqueen-plus-v3 measured.py': [
    {
      afterMs: 30_000,
      says: 'it is back where it began within 2 mm',
      holds(run) {
        hasEnded(run);
        const { turnedRad, pose } = robotOf(run);
        expect(Math.abs((turnedRad * 180) / Math.PI + 360)).toBeLessThan(1);
        const [start] = traceOf(run);
        expect(Math.hypot(pose.xMm - start!.xMm, pose.yMm - start!.yMm)).toBeLessThan(2);
      },
    },
  ],
};

/** Every example of a servo moves a claw. */
const storyOf = ({ id }: { readonly id: string }, file: string): readonly Moment[] =>
  STORIES[`${id} ${file}`] ?? (file === 'servo.py' ? opensAndCloses : []);

/** The bumper is there to touch the walls. */
const touches = ({ example }: ExampleOf): boolean => example.file === 'bumper.py';

const drivesWell = (entry: ExampleOf, seconds: number): Moment => ({
  afterMs: seconds * 1000,
  says: `it drives ${seconds} s without an exception or a collision`,
  holds(run) {
    expect(run.ended?.exception ?? null).toBeNull();
    const { type, collisions } = robotOf(run);
    expect(type).toBe(entry.robot.id);
    if (touches(entry)) expect(collisions).toBeGreaterThan(0);
    else expect(collisions).toBe(0);
  },
});

/** A program without its comments: what a run depends on. */
const codeOf = (program: string): string =>
  program
    .split('\n')
    .map((line) => line.replace(/^((?:"[^"]*"|'[^']*'|[^#"'])*?) *#.*$/, '$1'))
    .filter((line) => line !== '')
    .join('\n');

/**
 * Every example in English, and in those languages in which it differs in more than comments, by its strings. What it shows
 * beyond its first seconds is looked at in English.
 */
const drives = examples.flatMap((entry) => {
  const { robot, example } = entry;
  const story = storyOf(robot, example.file);
  const languages = LANGUAGES.filter(
    (language) => language === 'en' || codeOf(example.source[language]) !== codeOf(example.source.en),
  );
  return languages.map((language) => {
    const isLong = language === 'en' || touches(entry);
    const moments = [drivesWell(entry, isLong ? 8 : 3), ...(language === 'en' ? story : [])];
    moments.sort((a, b) => a.afterMs - b.afterMs);
    const says = moments.map((moment) => moment.says).join('; ');
    return { name: robot.name, file: example.file, language, says, entry, moments };
  });
});

describe('the examples of the robots', () => {
  it('name courses that exist and options that their robots have', () => {
    for (const { example, robot } of examples) {
      const { course, options = {} } = example;
      if (course !== undefined) expect(courses.map(({ id }) => id)).toContain(course);
      expect(optionProblem(robot.options, options), example.file).toBeNull();
    }
  });

  it('are those of the stories, wherever one promises a quarter turn or moves a servo', () => {
    const named = examples.map(({ robot, example }) => `${robot.id} ${example.file}`);
    expect(named).toEqual(expect.arrayContaining(Object.keys(STORIES)));
    for (const { robot, example } of examples) {
      const story = storyOf(robot, example.file);
      if (/quarter turn/i.test(example.source.en)) expect(story, example.file).toContain(fourQuarters);
      if (example.file === 'servo.py') expect(story, robot.id).toEqual(expect.arrayContaining(opensAndCloses));
    }
  });

  it.each(drives)(
    '$name, $file ($language), opened on a first visit: $says',
    { timeout: 60_000 },
    async ({ entry, language, moments }) => {
      const run = await begin(withExample(found, entry, language), entry.robot.id);
      for (const { afterMs, holds } of moments) {
        run.advanceTo(afterMs * 1000);
        holds(run);
      }
    },
  );

  it.each([
    [200, 40],
    [400, 60],
  ])(
    'follow a circle of %i mm radius all the way round in %i s: Maqueen Plus V2, line.py',
    async (radiusMm, seconds) => {
      const centre = [1056, 1000 + radiusMm] as const;
      const points = Array.from({ length: 91 }, (_, i): Point => {
        const angle = (i / 90) * 2 * Math.PI;
        return [centre[0] + radiusMm * Math.sin(angle), centre[1] - radiusMm * Math.cos(angle)];
      });
      const line: SceneObject = { id: 'line', type: 'stroke', points, width: 20, color: 'black' };
      const robot = { ...defaultScene().robot, at: [1000, 1000] as const };
      const scene: Scene = { ...defaultScene(), size: [2000, 2000], robot, objects: [line] };
      const run = await begin(
        { ...withExample(found, entryOf('maqueen-plus-v2', 'line.py'), 'en'), scene },
        'maqueen-plus-v2',
      );
      run.advanceTo(seconds * 1_000_000);
      const { turnedRad, pose } = robotOf(run);
      expect(turnedRad).toBeGreaterThan(2 * Math.PI);
      expect(Math.abs(Math.hypot(pose.xMm - centre[0], pose.yMm - centre[1]) - radiusMm)).toBeLessThan(60);
    },
  );
});

describe('opening an example', () => {
  it('brings the arena it is made for, and its options with it', () => {
    const { scene, course, files } = withExample(found, entryOf('maqueen-lite', 'servo.py'), 'en');
    expect([course, scene.size, scene.objects]).toEqual(['empty', [1200, 900], []]);
    expect(scene.robot.options).toEqual({ S1: 'claw' });
    expect(files[0]?.text).toContain('# A servo at port S1');
  });

  it('brings its own arena after another example, without what the other one needed', () => {
    const servo = withExample(found, entryOf('maqueen-lite', 'servo.py'), 'de');
    for (const file of ['square.py', 'lights.py']) {
      const { scene, course } = withExample(servo, entryOf('maqueen-lite', file), 'de');
      expect([course, scene.robot.options]).toEqual(['empty', {}]);
    }
    expect(withExample(servo, entryOf('callibot', 'line.py'), 'de').course).toBe('closed-line');
  });

  it('leaves an arena alone that the pupil built or changed', () => {
    const own = { ...found, scene: { ...found.scene, robot: { ...found.scene.robot, at: [500, 400] as const } } };
    const opened = withExample(own, entryOf('maqueen-lite', 'servo.py'), 'de');
    expect(opened.scene).toBe(own.scene);
    expect(opened.files).not.toEqual(own.files);
  });
});
