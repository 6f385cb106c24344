import * as v from 'valibot';
import { describe, expect, it } from 'vitest';

import { createRng, type Rng } from '#core/rng';
import { LANGUAGES } from '#core/languages';
import { fuzzRuns } from '#core/testing/fuzz-runs';
import { FILE_BYTES, MAIN, projectLimits } from '#project/project';
import { mutatedTree } from '#scene/testing/mutate';

import { PARTS, type SimulatorEvent } from '../simulator';
import { RecordingSimulator } from '../testing/recording-simulator';
import { createWebTigerPythonAdapter } from './adapter';
import { pageData } from './messages';

/** Only against an endless loop. */
const TIME_LIMIT_MS = 60_000 + 20 * fuzzRuns;

const MESSAGES: readonly unknown[] = [
  { type: 'files', data: [{ name: MAIN, data: 'print(1)' }] },
  { type: 'files', data: [{ name: 'drive.py', data: 'x' }, { name: MAIN, data: 'import drive' }] }, // prettier-ignore
  { type: 'files', data: 'print(2)' },
  { type: 'settings', data: { device: 'micro:bit', lang: 'de', dark_mode: true, layout: [['Editor', 'Canvas'], 'Console'] } }, // prettier-ignore
  { type: 'settings', data: { hide_topbar: 'true', full_screen: false, layout: '["Canvas"]', device: '-' } },
  { type: 'settings', data: { code: 'print(3)', lang: 'fr' } },
  { type: 'run_code' },
  { type: 'run_code', data: null },
  { kind: 'flash', filesystem: {} },
  { parcours: 1, type: 'hello' },
];
const TRACEBACK = 'Traceback (most recent call last):\n  File "main.py", line 1\nNameError: x\n';
const PRINTED = ['1\r\n', 'Trace', 'back', TRACEBACK, TRACEBACK.slice(0, 40), TRACEBACK.slice(40), '\r', '\n', ''];

const oneOf = <T>(list: readonly T[], rng: Rng): T => list[Math.floor(rng.unit() * list.length)]!;

/** Events of the run between two messages. */
function someEvent(rng: Rng): SimulatorEvent {
  const ended = { kind: oneOf(['finished', 'exception', 'stopped'] as const, rng), timeUs: 0 };
  const exception = { type: 'NameError', message: 'x', line: 1, traceback: TRACEBACK };
  return oneOf<SimulatorEvent>(
    [
      { type: 'started' },
      { type: 'output', text: oneOf(PRINTED, rng) },
      { type: 'program-ended', ended: { ...ended, exception: rng.unit() < 0.5 ? null : exception }, verdict: null },
      { type: 'program-restarted' },
      { type: 'phase', phase: oneOf(['ready', 'stopped', 'killed', 'failed'] as const, rng) },
      { type: 'failed', message: 'Broken.' },
    ],
    rng,
  );
}

describe('messages of any shape to the adapter of WebTigerPython', () => {
  it(
    `never throw, and change nothing but the files and the settings it has (${String(fuzzRuns)} messages)`,
    async () => {
      const simulator = new RecordingSimulator();
      const posted = new Map<string, number>();
      const adapter = createWebTigerPythonAdapter(simulator, {
        nowMs: () => 0,
        post(message) {
          const { type, data } = message as { type: keyof typeof pageData; data: unknown };
          expect(Object.keys(message)).toEqual(['type', 'data']);
          v.parse(pageData[type], data);
          posted.set(type, (posted.get(type) ?? 0) + 1);
        },
      });
      let taken = 0;
      for (let seed = 1; seed <= fuzzRuns; seed += 1) {
        const rng = createRng(seed);
        const before = { project: simulator.project(), settings: simulator.settings() };
        const message = oneOf(MESSAGES, rng);
        adapter.receive(rng.unit() < 0.1 ? message : mutatedTree(message, rng, false));
        const did = simulator.calls.splice(0).map(({ call }) => call);
        taken += did.length;
        // A requested run begins after this message.
        expect(did.every((call) => ['setFiles', 'change', 'run'].includes(call))).toBe(true);
        const { files, ...rest } = simulator.project();
        expect({ ...rest, settings: null }).toEqual({ ...before.project, files: undefined, settings: null });
        expect(files[0]?.name).toBe(MAIN);
        expect(files.length).toBeLessThanOrEqual(projectLimits.files);
        expect(files.every(({ text }) => text.length <= FILE_BYTES)).toBe(true);
        const { language, theme, device, parts, ...others } = simulator.settings();
        expect(others).toEqual({ ...before.settings, language: undefined, theme: undefined, device: undefined, parts: undefined }); // prettier-ignore
        expect(LANGUAGES).toContain(language);
        expect(['system', 'light', 'dark']).toContain(theme);
        expect(['auto', 'microbit-v2', 'calliope-mini-2', 'calliope-mini-3']).toContain(device);
        expect(PARTS.filter((part) => parts.includes(part))).toEqual(parts);
        simulator.tell(someEvent(rng));
        if (seed % 100 === 0) await Promise.resolve();
      }
      expect(taken).toBeGreaterThan(fuzzRuns / 10);
      for (const type of ['code', 'output', 'error', 'full_output'])
        expect(posted.get(type), type).toBeGreaterThan(fuzzRuns / 100);
      expect(({} as Record<string, unknown>)['polluted']).toBeUndefined();
    },
    TIME_LIMIT_MS,
  );

  it('are cheap to refuse: what is far too large is not looked into', () => {
    const simulator = new RecordingSimulator();
    let looked = 0;
    const curious = new Proxy({}, { get: () => ((looked += 1), undefined) });
    const adapter = createWebTigerPythonAdapter(simulator, { nowMs: () => 0, post: () => undefined });
    adapter.receive({ type: 'files', data: Array.from({ length: 100_000 }, () => curious) });
    adapter.receive({ type: 'files', data: 'x'.repeat(FILE_BYTES + 1) });
    adapter.receive({ type: 'settings', data: { layout: Array.from({ length: 100_000 }, () => curious) } });
    const own: unknown[] = ['Canvas'];
    own.push(own, own);
    adapter.receive({ type: 'settings', data: { layout: own } });
    expect(simulator.calls.splice(0)).toEqual([{ call: 'change', settings: { parts: ['bar', 'board', 'arena'] } }]);
    const trap = { get type(): string { throw new Error('looked at'); } }; // prettier-ignore
    adapter.receive(trap);
    expect(looked).toBe(0);
    expect(simulator.calls).toEqual([]);
  });
});
