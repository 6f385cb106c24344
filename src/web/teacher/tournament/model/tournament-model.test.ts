import { describe, expect, it } from 'vitest';

import { handInOfFiles } from '#check/hand-in/read-hand-in';
import type { Answer } from '#check/lane';
import type { Source } from '#intake/sources';
import { parseTournament } from '#lab/tournament/file';
import type { RunAnswer, RunRequest } from '#lab/run-request';
import { parseSceneValue } from '#scene/parse';

import { TournamentModel } from './tournament-model';

const course = parseSceneValue({
  ...{ format: 'parcours-scene', version: 4, name: 'Ring', size: [1500, 1500] },
  ...{ robot: { at: [560, 700], heading: 0 }, task: { seconds: 60, robots: 'ring' } },
  objects: [
    { id: 'ring', type: 'target', at: [750, 750], size: [840, 840], round: true },
    { id: 'rival', type: 'start', at: [930, 820], heading: 180 },
  ],
});
if ('problem' in course) throw new Error(course.problem);
const { scene } = course;

const source = (name: string, text = `# ${name}`): Source => ({
  name,
  read: () => ({ handIn: handInOfFiles([{ name: 'main.py', text }]) }),
});

type Heard = (answer: Answer<RunAnswer>) => void;
/** Threads that wait until a test answers; the later name in the alphabet wins. */
function tournament(lanes = 2) {
  const asked: { readonly request: RunRequest; readonly heard: Heard }[] = [];
  const model = new TournamentModel({
    starter: () =>
      Promise.resolve((heard: Heard) => ({
        ask: (request: RunRequest) => void asked.push({ request, heard }),
        pulse: () => ({ beat: 0, world: 0 }),
        stop: () => undefined,
      })),
    every: () => () => undefined,
    lanes,
  });
  model.course.value = { name: 'Ring', from: 'sumo', scene };
  const nextTick = (): Promise<void> => new Promise((done) => setTimeout(done));
  async function answer(count = Infinity): Promise<void> {
    for (let done = 0; done < count; done++) {
      await nextTick();
      const one = asked.shift();
      if (one === undefined) return;
      one.heard({ result: resultOf(one.request) });
    }
    await nextTick();
  }
  return { model, asked, answer };
}
function resultOf({ setup }: RunRequest): RunAnswer {
  const [a = '', b = ''] = setup.devices.map(({ files }) => files['main.py']);
  const state = (hasWon: boolean) => ({ state: hasWon ? 'passed' : 'failed', atMs: 5000, reason: hasWon ? null : 'left' }); // prettier-ignore
  return {
    outcome: { passed: a > b, atMs: 5000, touches: 0, reason: null, traceHash: `${a}${b}${setup.seed}` },
    verdict: { atMs: 5000, robots: [state(a > b), state(b > a)] },
  } as unknown as RunAnswer;
}

describe('a tournament on the page', () => {
  it('has its table grow while matches end, and goes on with a final round', async () => {
    const { model, answer } = tournament();
    await model.add(['a', 'b', 'c', 'd'].map((name) => source(name)));
    const over = model.start();
    await answer(3);
    expect(model.stages.value).toMatchObject([{ of: 12, matches: { length: 3 } }]);
    await answer();
    await over;
    expect(model.phase.value).toBe('over');
    expect(model.stages.value).toMatchObject([
      { mode: 'league', matches: { length: 12 } },
      { mode: 'knockout', names: ['d', 'c', 'b', 'a'], of: 6, matches: { length: 6 } },
    ]);
    // The first rounds: nobody plays twice before all have played.
    expect(model.stages.value[0]?.ended.slice(0, 4).map(({ a }) => a).sort()).toEqual([0, 1, 2, 3]); // prettier-ignore
  });

  it('stopped and started again, plays only what is missing', async () => {
    const { model, asked, answer } = tournament(1);
    await model.add(['a', 'b'].map((name) => source(name)));
    void model.start();
    await answer(1);
    expect(asked).toHaveLength(1);
    model.stop();
    expect([model.phase.value, model.stages.value[0]?.matches.length]).toEqual(['stopped', 1]);
    asked.length = 0;
    const over = model.start();
    await answer(1);
    await over;
    expect([model.phase.value, asked.length]).toEqual(['over', 0]);
  });

  it('stopped and started again, has its matches in the order in which they had ended', async () => {
    const { model, asked, answer } = tournament(1);
    await model.add(['a', 'b', 'c', 'd'].map((name) => source(name)));
    void model.start();
    await answer(5);
    const before = model.stages.value[0]?.ended ?? [];
    expect(before).not.toEqual(model.stages.value[0]?.matches);
    model.stop();
    asked.length = 0;
    void model.start();
    await answer(1);
    expect(model.stages.value[0]?.ended.slice(0, before.length)).toEqual(before);
  });

  it('saved as a file and opened again, is played once more and compared', async () => {
    const first = tournament();
    await first.model.add(['a', 'b'].map((name) => source(name)));
    void first.model.start();
    await first.answer();
    const text = first.model.file() ?? '';
    for (const [changed, differing] of [
      [text, 0],
      [text.replace('"winner":"b"', '"winner":"a"'), 1],
    ] as const) {
      const read = parseTournament(changed);
      if ('problem' in read) throw new Error(read.problem);
      const second = tournament();
      void second.model.open(read.tournament);
      expect(second.model.differing.value).toBeNull();
      await second.answer();
      expect(second.model.differing.value).toBe(differing);
    }
  });

  it('is played by the programs with which it has begun, also when the list changes meanwhile', async () => {
    const { model, answer } = tournament(1);
    await model.add(['b', 'c'].map((name) => source(name)));
    void model.start();
    await answer(1);
    await model.add([source('a')]);
    model.remove('b');
    const [first] = model.stages.value;
    const files = (): readonly unknown[] =>
      (first && model.setupOf(first, { a: 0, b: 1, seed: 1 }))?.devices.map((one) => one.files['main.py']) ?? [];
    expect(files()).toEqual(['# b', '# c']);
    model.stop();
    void model.start();
    await answer();
    expect(model.stages.value).toMatchObject([{ names: ['b', 'c'], matches: { length: 2 } }]);
    expect(parseTournament(model.file() ?? '')).toMatchObject({
      tournament: { programs: [{ name: 'b' }, { name: 'c' }] },
    });
  });

  it('has something to lose from the first match until it is saved, and is another one after that', async () => {
    const { model, answer } = tournament();
    await model.add(['a', 'b'].map((name) => source(name)));
    void model.start();
    await answer(0);
    expect(model.isUnsaved.value).toBe(false);
    await answer();
    expect(model.isUnsaved.value).toBe(true);
    model.noteSaved();
    expect([model.isUnsaved.value, model.count.value]).toEqual([false, 0]);
    model.enter();
    expect([model.phase.value, model.count.value]).toEqual(['enter', 1]);
  });

  it('has nothing to lose that is in a file: not while that is played again, and not its programs after that', async () => {
    const { model, answer } = tournament();
    const isLost = (): readonly boolean[] => [model.isUnsaved.value, model.hasUnsavedPrograms.value];
    await model.add(['a', 'b'].map((name) => source(name)));
    expect(isLost()).toEqual([false, true]);
    void model.start();
    await answer();
    const read = parseTournament(model.file() ?? '');
    if ('problem' in read) throw new Error(read.problem);
    model.noteSaved();
    expect(isLost()).toEqual([false, false]);
    model.enter();
    expect(isLost()).toEqual([false, false]);
    model.remove('a');
    expect(isLost()).toEqual([false, true]);
    void model.open(read.tournament);
    await answer(1);
    expect([model.stages.value[0]?.ended.length, ...isLost()]).toEqual([1, false, false]);
    model.enter();
    expect(isLost()).toEqual([false, false]);
    await model.add([source('c')]);
    expect(isLost()).toEqual([false, true]);
  });

  it('has no brackets in a course for one, whatever was chosen for another', async () => {
    const { model } = tournament();
    const { robots: _, ...task } = scene.task;
    model.course.value = { name: 'Race', from: 'race', scene: { ...scene, task } };
    model.mode.value = 'knockout';
    await model.add(['a', 'b'].map((name) => source(name)));
    expect(model.draw.value).toMatchObject({ mode: 'league', isAlone: true });
  });

  it('says why a program cannot play, and plays without it', async () => {
    const { model } = tournament();
    await model.add([source('a'), { name: 'b', read: () => ({ problem: { code: 'no-main', params: {} } }) }]);
    expect(model.programs.value.map(({ problem }) => problem?.code)).toEqual([undefined, 'no-main']);
    expect(model.draw.value?.names).toEqual(['a']);
  });
});
