import * as v from 'valibot';
import { describe, expect, it } from 'vitest';

import { createRng, type Rng } from '#core/rng';
import { fuzzRuns } from '#core/testing/fuzz-runs';
import { mutatedTree } from '#scene/testing/mutate';

import { RecordingSimulator, type RecordedCall } from '../testing/recording-simulator';
import { createMicrobitAdapter } from './adapter';
import { LABEL_NAMES, microbitEvent } from './messages';

/** Only against an endless loop. */
const TIME_LIMIT_MS = 60_000 + 20 * fuzzRuns;
/** Messages to one page before it is loaded anew. */
const PER_PAGE = 50;

const bytes = (text: string): Uint8Array => new TextEncoder().encode(text);

/** Messages that hosts usually send. */
const USUAL: readonly object[] = [
  { kind: 'config', language: 'fr', translations: { 'button-a': 'Bouton A', 'start-simulator': 'Démarrer' } },
  { kind: 'flash', filesystem: { 'main.py': bytes('print(1)'), 'helper.py': bytes('x = 1') } },
  { kind: 'flash', filesystem: { 'main.py': bytes('import mbrobot_plusV2') } },
  { kind: 'flash', filesystem: { 'main.py': Uint8Array.of(0xc3, 0x28), 'a b.py': bytes('') } },
  { kind: 'stop' },
  { kind: 'reset' },
  { kind: 'mute' },
  { kind: 'unmute' },
  { kind: 'serial_input', data: 'hallo\r\n' },
  { kind: 'radio_input', data: Uint8Array.of(1, 0, 1, 104, 105) },
  { kind: 'set_value', id: 'temperature', value: 30 },
  { kind: 'set_value', id: 'gesture', value: 'shake' },
  { kind: 'set_value', id: 'buttonA', value: '1' },
];

/** A message like those, whole, changed or invented. Bytes may become lists or objects, as careless hosts send them. */
function message(rng: Rng): unknown {
  const usual = USUAL[rng.u32() % USUAL.length];
  const way = rng.unit();
  if (way < 0.25) return usual;
  const mutated = mutatedTree(usual, rng, false);
  return way < 0.6 ? withBytes(mutated, rng) : mutated;
}

/** Things that occur a thousand times are changed once: a thousand thousand objects would take most of the time. */
function withBytes(value: unknown, rng: Rng, known = new Map<object, unknown>()): unknown {
  if (typeof value !== 'object' || value === null) return value;
  if (!known.has(value)) known.set(value, changed(value, rng, known));
  return known.get(value);
}

function changed(value: object, rng: Rng, known: Map<object, unknown>): unknown {
  const values = Object.values(value);
  if (values.length > 0 && values.every((one) => typeof one === 'number'))
    return Uint8Array.from({ length: rng.u32() % 40 }, () => rng.u32());
  return Object.fromEntries(Object.entries(value).map(([key, one]) => [key, withBytes(one, rng, known)]));
}

/** Everything that a host of this dialect may do, by kind. */
const ALLOWED: Readonly<Record<string, readonly RecordedCall['call'][]>> = {
  config: ['change'],
  flash: ['setFiles', 'change', 'run'],
  stop: ['stop'],
  reset: ['setFiles', 'run'],
  mute: ['change'],
  unmute: ['change'],
  serial_input: ['input'],
  radio_input: ['input'],
  set_value: ['input'],
};
const CHANGED = ['language', 'labels', 'muted', 'robot', 'parts'];

const kindOf = (value: unknown): string =>
  typeof value === 'object' && value !== null && 'kind' in value && typeof value.kind === 'string' ? value.kind : '';

/** Properties of the page that this dialect cannot express. */
function untouched(simulator: RecordingSimulator): string {
  const { scene, course } = simulator.project();
  const settings = Object.entries(simulator.settings()).filter(([name]) => !CHANGED.includes(name));
  return JSON.stringify([settings, scene, course]);
}

function expectAllowed(call: RecordedCall, kind: string): void {
  expect(ALLOWED[kind] ?? []).toContain(call.call);
  if (call.call !== 'change') return;
  for (const name of Object.keys(call.settings)) expect(CHANGED).toContain(name);
  for (const name of Object.keys(call.settings.labels ?? {})) expect(LABEL_NAMES).toContain(name);
}

describe('randomly changed messages of the micro:bit dialect', () => {
  it(
    `throw nothing and change nothing but what they may (${String(fuzzRuns)} messages)`,
    async () => {
      const counts = new Map<string, number>();
      const count = (name: string): unknown => counts.set(name, (counts.get(name) ?? 0) + 1);
      for (let seed = 1; seed <= fuzzRuns;) {
        const simulator = new RecordingSimulator();
        const said: object[] = [];
        const adapter = createMicrobitAdapter(simulator, { post: (one) => void said.push(one), nowMs: () => 0 });
        const fixed = untouched(simulator);
        for (let of = 0; of < PER_PAGE && seed <= fuzzRuns; of += 1, seed += 1) {
          const sent = message(createRng(seed));
          const calls = simulator.calls.length;
          const files = simulator.project().files;
          said.length = 0;
          adapter.receive(sent);
          const done = simulator.calls.slice(calls);
          for (const call of done) expectAllowed(call, kindOf(sent));
          if (seed % 3 === 0) await Promise.resolve();
          expect(simulator.calls.length, `seed ${String(seed)}`).toBe(calls + done.length);
          for (const one of said) expect(v.is(microbitEvent, one), `seed ${String(seed)}: ${JSON.stringify(one)}`).toBe(true); // prettier-ignore
          expect(said.length, `seed ${String(seed)}`).toBeLessThan(5);
          if (simulator.project().files !== files) expect(['flash', 'reset'], `seed ${String(seed)}`).toContain(kindOf(sent)); // prettier-ignore
          count(done.length > 0 ? kindOf(sent) : 'nothing');
        }
        expect(untouched(simulator)).toBe(fixed);
        adapter.close();
      }
      for (const name of [...Object.keys(ALLOWED), 'nothing'])
        expect(counts.get(name), name).toBeGreaterThan(fuzzRuns / 500);
    },
    TIME_LIMIT_MS,
  );
});
