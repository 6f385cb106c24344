import { readFileSync } from 'node:fs';
import { beforeAll, describe, expect, it } from 'vitest';

import { optionProblem } from '#core/option';
import { filesByName, type Project } from '#project/project';
import { Simulation } from '#simulation/simulation';
import { LANGUAGES } from '../../page/i18n/texts';
import { projectOf } from './course';
import { courses } from './courses';
import { examples, withExample, type ExampleOf } from './examples';

let firmware: WebAssembly.Module;
beforeAll(() => {
  firmware = new WebAssembly.Module(readFileSync('.cache/vm/vm.wasm'));
});

/** What a first visit finds. */
const found: Project = projectOf(
  courses.find(({ id }) => id === 'closed-line')!,
  'de',
);
const entryOf = (robot: string, file: string): ExampleOf =>
  examples.find((entry) => entry.robot.id === robot && entry.example.file === file)!;

async function run({ scene, files }: Project, robot: string, forMs: number): Promise<Simulation> {
  const setup = { scene, files: filesByName(files), robot, board: 'auto', seed: 1, reality: 0, keepTrace: true };
  const simulation = await Simulation.create(setup, firmware);
  simulation.advanceTo(forMs * 1000);
  return simulation;
}

/** Headings in degrees at which the robot drove straight on or stood for at least 0.1 s, one behind the other. */
function straightHeadings({ trace }: Simulation): number[] {
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

/** The bumper is there to touch the walls. */
const touches = ({ example }: ExampleOf): boolean => example.file === 'bumper.py';
const inEach = examples.flatMap((entry) =>
  LANGUAGES.map((language) => [entry.robot.name, entry.example.file, language, entry] as const),
);

describe('the examples of the robots', () => {
  it('name courses that exist and options that their robots have', () => {
    for (const { example, robot } of examples) {
      const { course, options = {} } = example;
      if (course !== undefined) expect(courses.map(({ id }) => id)).toContain(course);
      expect(optionProblem(robot.options, options), example.file).toBeNull();
    }
  });

  it.each(inEach)(
    '%s, %s (%s): opened on a first visit, it drives 8 s without an exception or a collision',
    { timeout: 30_000 },
    async (_robot, file, language, entry) => {
      const simulation = await run(withExample(found, entry, language), entry.robot.id, 8000);
      expect(simulation.ended?.exception ?? null).toBeNull();
      const { robot } = simulation.snapshot();
      expect(robot?.type).toBe(entry.robot.id);
      if (touches(entry)) expect(robot?.collisions).toBeGreaterThan(0);
      else expect(robot?.collisions, file).toBe(0);
    },
  );

  const withQuarters = inEach.filter(([, , , { example }]) => /quarter turn/i.test(example.source.en));
  it.each(withQuarters)(
    '%s, %s (%s): a quarter turn is 90° within 3°, four times',
    { timeout: 30_000 },
    async (_robot, _file, language, entry) => {
      const headings = straightHeadings(await run(withExample(found, entry, language), entry.robot.id, 12_000));
      const turns = headings.slice(1, 5).map((heading, i) => heading - headings[i]!);
      expect(turns).toHaveLength(4);
      for (const turn of turns) expect(Math.abs(turn - 90)).toBeLessThan(3);
    },
  );

  it('that move a servo have a claw on it, whose jaws move', { timeout: 30_000 }, async () => {
    const servos = examples.filter(({ example }) => example.file === 'servo.py');
    expect(servos.map(({ robot }) => robot.id)).toEqual(['maqueen-lite', 'maqueen-plus-v2', 'callibot']);
    for (const entry of servos) {
      for (const [forMs, angleDeg] of [
        [900, 30],
        [1900, 90],
      ] as const) {
        const simulation = await run(withExample(found, entry, 'de'), entry.robot.id, forMs);
        const [claw] = simulation.snapshot().robot!.state.attachments;
        expect(claw?.type, entry.robot.id).toBe('claw');
        expect(Math.abs(claw!.angleDeg - angleDeg), entry.robot.id).toBeLessThan(5);
      }
    }
  });
});

describe('opening an example', () => {
  it('brings the arena it is made for, and its options with it', () => {
    const { scene, course, files } = withExample(found, entryOf('maqueen-lite', 'servo.py'), 'en');
    expect([course, scene.size, scene.objects]).toEqual(['empty', [1200, 900], []]);
    expect(scene.robot.options).toEqual({ S1: 'claw' });
    expect(files[0]?.text).toContain('# A servo at port S1');
  });

  it('after another example brings its own arena, without what the other one needed', () => {
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
