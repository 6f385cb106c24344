import { nextTick } from 'vue';

import type { InputAction } from '#simulation/input';

import { SOLO } from '#simulation/run-setup';
import type { Snapshot } from '#simulation/snapshot';
import type { TestPage } from './page';

/** A micro:bit at its start, without a robot, on an empty course; `changes` says what is different. */
export const pictureOf = (changes: Partial<Snapshot> = {}): Snapshot => ({
  board: 'microbit-v2',
  display: Array.from({ length: 25 }, () => 0),
  buttons: { a: false, b: false },
  touch: {},
  rgb: [],
  motors: [],
  microphoneOn: false,
  sensors: {},
  accelerometerRangeMg: 2000,
  soundThresholds: { quiet: 0, loud: 255 },
  power: 'on',
  radio: { on: false, group: 0, channel: 7 },
  logFull: false,
  sound: null,
  isSounding: false,
  timeUs: 0,
  running: 'program',
  awaitsInput: false,
  repl: false,
  position: null,
  robot: null,
  name: SOLO,
  others: [],
  blocks: {},
  movers: {},
  verdict: null,
  lights: [],
  arenaSenses: false,
  ...changes,
});

/** Starts a run, as the button does; its worker has begun. */
export async function startRun(page: TestPage): Promise<void> {
  await page.run.start();
  page.say({ type: 'started' });
  await nextTick();
}

/** The worker's next picture; `changes` says what is different from the start. */
export async function show(page: TestPage, changes: Partial<Snapshot> = {}): Promise<void> {
  page.say({ type: 'snapshot', snapshot: pictureOf(changes), trails: [[]] });
  await nextTick();
}

/** The inputs to the run so far. */
export const inputsOf = (page: TestPage): readonly InputAction[] =>
  page.sent.flatMap((message) => (message.type === 'input' ? [message.action] : []));
