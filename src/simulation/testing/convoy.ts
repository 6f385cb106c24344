import { defaultScene } from '#scene/scene';
import type { DeviceSetup, RunSetup } from '../run-setup';

const REMOTE = `
from microbit import *
import radio, random
radio.on()
words = ["ahead", "left", "right", "halt"]
for n in range(400):
    radio.send(str(n % 3) + words[random.randint(0, 3)])
    got = radio.receive_full()
    if got: print(n, got)
    display.show(n % 10)
    sleep(random.randint(5, 60))
1 / 0
`;

const ROBOT = `
from mbrobot import *
import radio
radio.on()
radio.config(queue=5, group=0)
setSpeed(60)
me = NUMBER % 3
while True:
    text = radio.receive()
    near = getDistance()
    if near < 12:
        backward()
        radio.send("near %d" % near)
    elif text and text[0] == str(me):
        word = text[1:]
        if word == "ahead": forward()
        elif word == "left": leftArc(0.1)
        elif word == "right": rightArc(0.1)
        else: stop()
        print(word, near, irLeft.read_digital())
    delay(15 + me)
`;

/**
 * A remote control and one to seven Maqueen Lites that it commands by radio. They look out for each other, answer, push
 * and drive over a line.
 */
export function convoyOf(count: number, change: Partial<RunSetup> = {}): RunSetup {
  const remote: DeviceSetup = { name: 'remote', files: { 'main.py': REMOTE }, robot: 'none', board: 'microbit-v2' };
  const robots = Array.from({ length: count - 1 }, (_, n): DeviceSetup => ({
    name: `robot ${n + 1}`,
    files: { 'main.py': ROBOT.replace('NUMBER', String(n)) },
    robot: 'maqueen-lite',
    board: 'microbit-v2',
    start: { type: null, at: [200 + 250 * (n % 4), 250 + 350 * (n >> 2)], heading: 90 * n, scale: 1, options: {} },
  }));
  const scene = {
    ...defaultScene(),
    objects: [
      { type: 'stroke', id: 'line', points: [[100, 300], [1100, 300], [1100, 700], [100, 700]], width: 20, color: 'black' }, // prettier-ignore
      { type: 'block', id: 'block', at: [600, 600], size: [60, 60], angle: 0 },
    ] as const,
  };
  return { scene, devices: [remote, ...robots], seed: 5, reality: 0, ...change };
}
