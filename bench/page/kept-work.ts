import { openedCourse } from '../../e2e/opened-course';

/** The closed line with its solution: the robot drives as long as one looks. */
export const closedLine = (): string => openedCourse('closed-line');

/** Drives to and fro, and turns a little, on and on. */
const TO_AND_FRO = `from mbrobot import *
setSpeed(30)
while True:
    forward()
    delay(700)
    backward()
    delay(700)
    left()
    delay(200)
`;

/** Four Maqueen Lite beside each other on an empty floor, each with a device of its own. */
export function fourRobots(): string {
  const work = JSON.parse(openedCourse('empty')) as { project: object };
  const files = [{ name: 'main.py', text: TO_AND_FRO }];
  const device = { device: 'auto', firmware: '', robot: 'maqueen-lite', robotOptions: {}, files, sameAs: '' };
  const others = ['B', 'C', 'D'].map((name) => ({ ...device, name }));
  return JSON.stringify({ ...work, project: { ...work.project, files, devices: { first: 'A', others } } });
}
