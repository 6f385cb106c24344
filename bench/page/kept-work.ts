import { openedCourse } from '../../e2e/opened-course';

/** The closed line with its solution: the robot drives as long as one looks. */
export const closedLine = (): string => openedCourse('closed-line');

/** Drives to and fro, and turns a little, on and on: the robot of this module. */
const toAndFro = (module: string): string => `from ${module} import *
setSpeed(30)
while True:
    forward()
    delay(700)
    backward()
    delay(700)
    left()
    delay(200)
`;

/** The same, and what it hears is sent on: the air is never quiet. */
const TALKING = `from mbrobot import *
import radio
radio.on()
setSpeed(30)
n = 0
while True:
    heard = radio.receive()
    n += 1
    radio.send(str(n))
    if heard and len(heard) % 2: forward()
    else: backward()
    print(n, heard)
    delay(300)
`;

/** Eight devices with a Maqueen Lite each, which talk by radio. */
export const eightDevices = (): string => robots('ABCDEFGH', TALKING);

/** Four Maqueen Lite beside each other on an empty floor, each with a device of its own. */
export const fourRobots = (): string => robots('ABCD', toAndFro('mbrobot'));

/** A Maqueen Plus V3 with its lidar in an empty arena, whose fan the page shows. */
export function lidarRobot(): string {
  const work = JSON.parse(openedCourse('empty')) as { project: object };
  const files = [{ name: 'main.py', text: toAndFro('mbrobot_plusV3') }];
  return JSON.stringify({ ...work, project: { ...work.project, files } });
}

function robots(letters: string, text: string): string {
  const work = JSON.parse(openedCourse('empty')) as { project: object };
  const files = [{ name: 'main.py', text }];
  const [first, ...further] = letters;
  const device = { device: 'auto', firmware: '', robot: 'maqueen-lite', robotOptions: {}, files, sameAs: '' };
  const others = further.map((name) => ({ ...device, name }));
  return JSON.stringify({ ...work, project: { ...work.project, files, devices: { first, others } } });
}
