import { expect, it } from 'vitest';
import { demoMap } from '#rescue-line/testing/maps';
import { lastLine, parcours, useFolder } from './testing/parcours';

const { file } = useFolder();

/** Follows the line, drives in an arc around the obstacle, and stops where the line has ended. */
const PROGRAM = `from mbrobot import *

def dark():
    return not irLeft.read_digital() or not irRight.read_digital()

def around():
    right()
    delay(465)
    leftArc(0.15)
    delay(1500)
    while not dark():
        delay(5)
    forward()
    delay(150)
    right()
    delay(465)
    stop()

lost = 0
setSpeed(40)
while lost < 80:
    if getDistance() < 6:
        around()
    left_bright = irLeft.read_digital()
    right_bright = irRight.read_digital()
    if not left_bright and not right_bright:
        forward()
    elif not left_bright:
        leftArc(0.06)
    elif not right_bright:
        rightArc(0.06)
    lost = lost + 1 if left_bright and right_bright else 0
    delay(10)
stop()
`;

it('a program drives over a map of RoboCup Junior and has all 125 points; a lack of progress that is called costs 11', () => {
  const program = file('rescue.py', PROGRAM);
  const map = file('map.json', JSON.stringify(demoMap()));
  const run = (...more: string[]) => lastLine(parcours('run', program, '--scene', map, '--until-verdict', '--json', ...more).out).verdict; // prettier-ignore
  expect(run()).toMatchObject({ state: 'passed', points: { score: 125, lacks: 0 } });
  const calls = file('calls.json', '[{ "at": "2s", "noProgress": true }]');
  expect(run('--input', calls)).toMatchObject({ state: 'passed', points: { score: 114, lacks: 1 } });
}, 120_000);
