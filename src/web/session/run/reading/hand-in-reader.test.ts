// @vitest-environment happy-dom
import { describe, expect, it } from 'vitest';

import { HandInReader, READ_MS } from './hand-in-reader';
import { Reader, type ToReader } from '../worker/reader';

const added = (...names: string[]) => names.map((path) => ({ path, file: new File([path], path) }));
const isOf = (message: ToReader, place: number): boolean => message.type === 'read' && message.place === place;

/**
 * A reader whose workers are in this thread, and the time that passes for it.
 *
 * @param hangs whether a worker, counted from 1, never answers a message
 */
function readerWith(hangs: (message: ToReader, worker: number) => boolean) {
  const watching = new Set<() => void>();
  let workers = 0;
  const reader = new HandInReader(() => ({}), {
    start(heard) {
      const [worker, real] = [(workers += 1), new Reader()];
      return {
        send(message) {
          if (!hangs(message, worker)) void real.answer(message).then(heard);
        },
        stop: () => undefined,
      };
    },
    every(_, act) {
      watching.add(act);
      return () => watching.delete(act);
    },
  });
  /** Lets pass as many looks as use up a hand-in's whole time. */
  const pass = async (): Promise<void> => {
    await settled();
    for (let look = 0; look <= READ_MS / 200; look += 1) for (const act of watching) act();
    await settled();
  };
  return { reader, pass, workers: () => workers };
}

const settled = (): Promise<void> => new Promise((resolve) => setTimeout(resolve, 5));

describe('hand-ins that are read beside the page', () => {
  it('are read by one worker, each when its turn comes', async () => {
    const { reader, workers } = readerWith(() => false);
    const { sources } = await reader.open(added('Ada.py', 'Ben.py', 'Cem.zip'));
    expect(sources.map(({ name }) => name)).toEqual(['Ada', 'Ben', 'Cem.zip']);
    const contents = await Promise.all(sources.map(async (source) => source.read()));
    expect(contents).toMatchObject([
      { handIn: { project: { files: [{ text: 'Ada.py' }] } } },
      { handIn: { project: { files: [{ text: 'Ben.py' }] } } },
      { problem: { code: 'zip' } },
    ]);
    expect(workers()).toBe(1);
  });

  it('are tried once more if they do not come to an end, then reported; the others are read', async () => {
    const { reader, pass, workers } = readerWith((message) => isOf(message, 1));
    const { sources } = await reader.open(added('Ada.py', 'Ben.py', 'Cem.py'));
    const reading = Promise.all(sources.map(async (source) => source.read()));
    await pass();
    expect(workers()).toBe(2);
    await pass();
    expect(await reading).toMatchObject([
      { handIn: {} },
      { problem: { code: 'slow', params: { seconds: 20 } } },
      { handIn: { project: { files: [{ text: 'Cem.py' }] } } },
    ]);
    expect(workers()).toBe(3);
  });

  it('are read at the second try where the machine was only busy', async () => {
    const { reader, pass } = readerWith((message, worker) => worker === 1 && isOf(message, 0));
    const [source] = (await reader.open(added('Ada.py'))).sources;
    const reading = Promise.resolve(source?.read());
    await pass();
    expect(await reading).toMatchObject({ handIn: {} });
  });

  it('are told by their names where not even the list of them comes', async () => {
    const { reader, pass } = readerWith(({ type }) => type === 'read-open');
    const opening = reader.open(added('class.zip'));
    await pass();
    await pass();
    const [source] = (await opening).sources;
    expect([source?.name, await source?.read()]).toEqual([
      'class.zip',
      { problem: { code: 'slow', params: { seconds: 20 } } },
    ]);
  });

  it('are reported where the code that reads did not come, also at a second try, and are read once it comes', async () => {
    let missing = Infinity;
    const reader = new HandInReader(() => ({}), {
      start(heard) {
        const real = new Reader();
        return {
          send(message) {
            missing -= 1;
            void (missing < 0 ? real.answer(message) : Promise.resolve({ type: 'read-unloaded' as const })).then(heard);
          },
          stop: () => undefined,
        };
      },
      every: () => () => undefined,
    });
    const open = async () => (await reader.open(added('Ada.py'))).sources[0]?.read();
    expect(await open()).toMatchObject({ problem: { code: 'unloaded' } });
    missing = 1; // a part that comes at the second try is no failure
    expect(await open()).toHaveProperty('handIn');
  });
});
