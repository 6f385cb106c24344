import * as v from 'valibot';
import { describe, expect, it } from 'vitest';

import { createRng, type Rng } from '#core/rng';
import { fuzzRuns } from '#core/testing/fuzz-runs';
import { projectToText } from '#project/file';
import { mutatedTree } from '#scene/testing/mutate';
import { fullProject } from '#project/testing/projects';
import { defaultScene } from '#scene/scene';
import { serializeScene } from '#scene/serialize';

import { RecordingSimulator, type RecordedCall } from '../testing/recording-simulator';
import { commandNames } from './command-schemas';
import { createParcoursAdapter } from './adapter';
import { eventSchemas } from './event-schemas';
import { limits } from './limits';
import type { CommandName, EventName } from './protocol';

/** Only against an endless loop. */
const TIME_LIMIT_MS = 60_000 + 20 * fuzzRuns;
/** Messages to one page before it is loaded anew. */
const PER_PAGE = 50;

const project: unknown = JSON.parse(projectToText(fullProject()));
const scene: unknown = JSON.parse(serializeScene({ ...defaultScene(), name: 'Bahn' }));
const wall = { type: 'wall', id: 'w1', from: [0, 0], to: [100, 0], thickness: 10 };

/** Messages that hosts usually send. */
const USUAL: readonly { readonly type: CommandName; readonly [field: string]: unknown }[] = [
  ...commandNames.map((type) => ({ type })),
  { type: 'hello', session: 's', client: 'a page', versions: [1] },
  { type: 'subscribe', events: ['output', 'ended'], snapshotHz: 10 },
  { type: 'set-project', project },
  { type: 'set-files', files: [{ name: 'main.py', text: 'print(1)' }, { name: 'drive.py', text: '' }] }, // prettier-ignore
  { type: 'set-scene', scene },
  { type: 'edit', edit: { type: 'add', objects: [wall] } },
  { type: 'set-robot', robot: 'maqueen-lite', robotOptions: {}, device: 'microbit-v2', firmware: '' },
  { type: 'settings', language: 'fr', theme: 'dark', muted: true, parts: ['board', 'arena'], labels: { 'button-a': 'A' } }, // prettier-ignore
  { type: 'set-mode', mode: 'build' },
  { type: 'run', paused: true },
  { type: 'set-break-points', points: [{ file: 'main.py', line: 3 }] },
  { type: 'step-line', step: 'over' },
  { type: 'run-to', file: 'main.py', line: 7 },
  { type: 'look-at', atMs: 1200 },
  { type: 'go-on', paused: true },
  { type: 'speed', speed: 4 },
  { type: 'seed', seed: 17 },
  { type: 'reality', reality: 0.5 },
  { type: 'place', xMm: 100, yMm: 200, headingDeg: 90 },
  { type: 'place-block', block: 'block-7', xMm: 100, yMm: 200, headingDeg: 90 },
  { type: 'press', button: 'a', down: true },
  { type: 'touch', pad: 'pinLogo', down: true },
  { type: 'sensor', sensor: 'lightLevel', value: 30 },
  { type: 'arena-senses', on: true },
  { type: 'serial', text: 'hello\r' },
  { type: 'radio', text: 'go' },
  { type: 'radio', bytes: [1, 2, 3] },
];

/** All possible effects of a command. */
const ALLOWED: Readonly<Partial<Record<CommandName, RecordedCall['call']>>> = {
  'set-project': 'openProject',
  'set-files': 'setFiles',
  'set-scene': 'setScene',
  edit: 'edit',
  'set-robot': 'change',
  settings: 'change',
  speed: 'change',
  seed: 'change',
  reality: 'change',
  'arena-senses': 'change',
  'set-mode': 'enterMode',
  run: 'run',
  stop: 'stop',
  reset: 'reset',
  pause: 'pause',
  resume: 'resume',
  step: 'step',
  place: 'input',
  'place-block': 'input',
  press: 'input',
  touch: 'input',
  sensor: 'input',
  serial: 'input',
  interrupt: 'input',
  radio: 'input',
  'clear-console': 'clearConsole',
  'set-break-points': 'setBreakPoints',
  'step-line': 'stepLine',
  'run-to': 'stepLine',
  'look-at': 'lookAt',
  'look-now': 'lookNow',
  'go-on': 'goOn',
};
const allowedCalls: ReadonlySet<string> = new Set(Object.values(ALLOWED));

const idOf = (seed: number): string => `command ${String(seed)}.`;

function messageOf(rng: Rng, id: string): unknown {
  const usual = { parcours: 1, id, ...USUAL[rng.u32() % USUAL.length] };
  return rng.unit() < 0.3 ? usual : mutatedTree(usual, rng, false);
}

const fieldsOf = (message: unknown): Readonly<Record<string, unknown>> =>
  typeof message === 'object' && message !== null ? (message as Record<string, unknown>) : {};

/** True if the manual promises this message of the page. */
function expectPromised(said: object, seed: number): void {
  const { type, reply, ok, ...data } = said as Readonly<Record<string, unknown>>;
  const where = `seed ${String(seed)}`;
  if (reply !== undefined) {
    expect(typeof ok, where).toBe('boolean');
    if (ok === false) expect(String(data['message']).length, where).toBeLessThan(limits.messageCharacters + 2);
    return;
  }
  const event = Object.fromEntries(Object.entries(data).filter(([key]) => key !== 'parcours'));
  expect(v.is(eventSchemas[type as EventName] as v.GenericSchema, event), `${where}: ${String(type)}`).toBe(true);
}

describe('randomly changed messages of our own dialect', () => {
  it(
    `throw nothing, change nothing but what they may, and are answered once each (${String(fuzzRuns)} messages)`,
    async () => {
      const done = new Map<string, number>();
      for (let seed = 1; seed <= fuzzRuns;) {
        const simulator = new RecordingSimulator();
        const said: object[] = [];
        const connection = { post: (message: object) => void said.push(message), nowMs: () => seed };
        const adapter = createParcoursAdapter(simulator, connection, {
          app: '',
          page: '',
          devices: [],
          robots: [],
          courses: [],
        });
        adapter.receive({ parcours: 1, type: 'hello' });
        for (let of = 0; of < PER_PAGE && seed <= fuzzRuns; of += 1, seed += 1) {
          const message = messageOf(createRng(seed), idOf(seed));
          const { id, parcours, type } = fieldsOf(message);
          const isAsked = id === idOf(seed) && typeof parcours === 'number';
          const before = said.length;
          const calls = simulator.calls.length;
          adapter.receive(message);
          for (let times = 0; times < 20; times += 1) await Promise.resolve();
          const answers = said.slice(before).filter((one) => 'reply' in one && one.reply === idOf(seed));
          expect(answers.length, `seed ${String(seed)}`).toBe(isAsked ? 1 : 0);
          for (const { call } of simulator.calls.slice(calls)) {
            expect(call, `seed ${String(seed)}`).toBe(ALLOWED[type as CommandName]);
            done.set(call, (done.get(call) ?? 0) + 1);
          }
        }
        for (const message of said) expectPromised(message, seed);
        adapter.close();
        expect(simulator.listenerCount).toBe(0);
      }
      for (const call of allowedCalls) expect(done.get(call), call).toBeGreaterThan(fuzzRuns / 1000);
      expect(({} as Record<string, unknown>)['polluted']).toBeUndefined();
    },
    TIME_LIMIT_MS,
  );
});
