import { readFileSync } from 'node:fs';
import { defaultScene } from '#scene/scene';
import { soloRun } from '#simulation/run-setup';
import { Simulation } from '#simulation/simulation';
import type { Subject } from './subject';

/** The calls that pupils make in loops without a pause. */
const CALLS = [
  'button_a.is_pressed()',
  'button_a.was_pressed()',
  'button_b.get_presses()',
  'pin0.read_digital()',
  'pin0.write_digital(1)',
  'pin1.read_analog()',
  'pin1.write_analog(512)',
  'pin2.is_touched()',
  'pin_logo.is_touched()',
  'pin0.get_mode()',
  'display.set_pixel(2, 2, 9)',
  'display.get_pixel(2, 2)',
  'display.show(im)',
  'display.show(Image.HEART)',
  'display.show(3)',
  'display.show("A")',
  'display.show(im * 5)',
  'display.show(1 if pin1.read_digital() else 0)',
  'display.clear()',
  'display.is_on()',
  'display.read_light_level()',
  'im.get_pixel(1, 1)',
  'im.set_pixel(1, 1, 5)',
  'im.copy()',
  'im.invert()',
  'im.fill(3)',
  'im.shift_left(1)',
  'im.shift_down(1)',
  'im.crop(1, 1, 3, 3)',
  'im.blit(im2, 0, 0, 5, 5, 1, 1)',
  'im + im2',
  'im - im2',
  'im * 5',
  'im / 2',
  'Image.HEART + im',
  'Image("99999:00000:99999:00000:99999")',
  'Image(5, 5)',
  'str(im)',
  'im.width()',
  'accelerometer.get_x()',
  'accelerometer.get_values()',
  'accelerometer.current_gesture()',
  'accelerometer.was_gesture("shake")',
  'compass.heading()',
  'compass.get_field_strength()',
  'temperature()',
  'microphone.sound_level()',
  'running_time()',
  'time.ticks_us()',
  'scale(5, from_=(0, 10), to=(0, 1023))',
  'np.fill((1, 2, 3))',
  'np[0] = (1, 2, 3)',
  'np[0]',
  'np.show()',
  'music.pitch(440, wait=False)',
  'music.stop()',
  'radio.receive()',
  'radio.send("hi")',
  'random.randint(1, 6)',
  '"{} {:.2f}".format(3, 1.5)',
];

const PROGRAM = (call: string): string => `
from microbit import *
import music, neopixel, radio, random, time
im = Image("11111:22222:33333:44444:55555")
im2 = im.copy()
np = neopixel.NeoPixel(pin8, 8)
radio.on()
def repeat():
    while True:
        ${call}
repeat()
`;

const AT_LEAST = 10;
/** How long each is measured: so much simulated time, or so much wall time if that is over first. */
const MOST_SIMULATED_US = 1_000_000;
const MOST_WALL_MS = 250;
const SLICE_US = 10_000;
/** Simulated time before the loop begins. */
const SET_UP_US = 300_000;

/** The slowest call, in real time: a program that does nothing else must keep up with the board on slow computers. */
export const apiCallsSubject: Subject<undefined> = {
  budgets: [
    { what: `headless, the slowest of ${CALLS.length} API calls in a loop`, budget: `>= ${AT_LEAST} x real time` },
  ],
  async measure() {
    let slowest = { call: '', factor: Infinity };
    for await (const one of apiCalls()) if (one.factor < slowest.factor) slowest = one;
    return [{ text: `${slowest.factor.toFixed(1)} x (${slowest.call})`, met: slowest.factor >= AT_LEAST }];
  },
};

/** Each call, and how much faster than real time a loop with it runs. */
export async function* apiCalls(): AsyncGenerator<{ readonly call: string; readonly factor: number }> {
  const firmware = new WebAssembly.Module(readFileSync('.cache/vm/vm.wasm'));
  for (const call of CALLS) yield { call, factor: await factorOf(call, firmware) };
}

/** Simulated time per wall time. */
async function factorOf(call: string, firmware: WebAssembly.Module): Promise<number> {
  const files = { 'main.py': PROGRAM(call) };
  const setup = { scene: defaultScene(), files, robot: 'none', board: 'auto', seed: 1, reality: 0 };
  const simulation = await Simulation.create(soloRun(setup), firmware);
  simulation.advanceTo(SET_UP_US);
  const startMs = performance.now();
  let us = 0;
  while (us < MOST_SIMULATED_US && performance.now() - startMs < MOST_WALL_MS) {
    us += SLICE_US;
    simulation.advanceTo(SET_UP_US + us);
  }
  const wallUs = (performance.now() - startMs) * 1000;
  if (simulation.ended) throw new Error(`${call}: ${simulation.takeConsole()}`);
  return us / wallUs;
}
