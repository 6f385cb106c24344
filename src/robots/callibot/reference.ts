import { fn, module, type, value } from '#reference/table';
import type { RobotReference } from '#reference/types';

/** The names of this robot's libraries (library/*.py) and short words on each. */
const callibotModule = module('callibot', {
  forward: fn('() -> None'),
  backward: fn('() -> None'),
  left: fn('() -> None'),
  right: fn('() -> None'),
  leftArc: fn('(radius: float) -> None'),
  rightArc: fn('(radius: float) -> None'),
  stop: fn('() -> None'),
  exit: fn('() -> None'),
  setSpeed: fn('(speed: int) -> None'),
  delay: fn('(ms: float) -> None'),
  getDistance: fn('() -> float'),
  irLeftValue: fn('() -> int'),
  irRightValue: fn('() -> int'),
  tsValue: fn('() -> int'),
  tsLeftValue: fn('() -> int'),
  tsRightValue: fn('() -> int'),
  setLED: fn('(on: int) -> None'),
  setLEDLeft: fn('(on: int) -> None'),
  setLEDRight: fn('(on: int) -> None'),
  setAlarm: fn('(on: int) -> None'),
  motL: value('Motor'),
  motR: value('Motor'),
  irLeft: value('Sensor'),
  irRight: value('Sensor'),
  ts: value('Sensor'),
  tsLeft: value('Sensor'),
  tsRight: value('Sensor'),
  w: fn('(d1: int, d2: int, s1: int, s2: int) -> None'),
  Motor: type(['(register: int)'], { rotate: fn('(speed: int) -> None') }),
  Sensor: type(['(bits: int)'], { read_digital: fn('() -> int'), getValue: fn('() -> int') }),
});

const callibotmot = module('callibotmot', {
  motL: value('Motor'),
  motR: value('Motor'),
  setLED: fn('(on: int) -> None'),
  delay: fn('(ms: float) -> None'),
  Motor: type(['(number: int)'], { rotate: fn('(speed: int) -> None') }),
});

const cbalarm = module('cbalarm', { setAlarm: fn('(on: int) -> None'), beep: fn('() -> None') });

const de = {
  callibot: 'Fährt den Calli:bot: Motoren, Sensoren und rote Lichter.',
  'callibot.forward': 'Fährt vorwärts, bis ein anderer Befehl kommt.',
  'callibot.backward': 'Fährt rückwärts, bis ein anderer Befehl kommt.',
  'callibot.left': 'Dreht sich an Ort nach links, bis ein anderer Befehl kommt.',
  'callibot.right': 'Dreht sich an Ort nach rechts, bis ein anderer Befehl kommt.',
  'callibot.leftArc': 'Fährt einen Kreis nach links. radius in Metern: 0.2 sind 20 cm.',
  'callibot.rightArc': 'Fährt einen Kreis nach rechts. radius in Metern: 0.2 sind 20 cm.',
  'callibot.stop': 'Hält an.',
  'callibot.exit': 'Hält an, wie stop().',
  'callibot.setSpeed': 'Tempo der folgenden Fahrbefehle, etwa 10 bis 200; am Anfang 50.',
  'callibot.delay': 'Wartet so viele Millisekunden; der Roboter tut unterdessen weiter, was er tut.',
  'callibot.getDistance': 'Abstand zum nächsten Hindernis in cm, mit einer Stelle nach dem Punkt.',
  'callibot.irLeftValue':
    'Linker Liniensensor: 1 auf hellem Boden, 0 auf dunklem; 0 auch, solange der Stossfänger gedrückt ist.',
  'callibot.irRightValue':
    'Rechter Liniensensor: 1 auf hellem Boden, 0 auf dunklem; 0 auch, solange der Stossfänger gedrückt ist.',
  'callibot.tsValue':
    '1, solange der Stossfänger links und rechts gedrückt ist. 0 auch, wenn nur einer der Liniensensoren Helles sieht.',
  'callibot.tsLeftValue':
    '1, solange der Stossfänger nur links gedrückt ist. 0 auch, wenn nur einer der Liniensensoren Helles sieht.',
  'callibot.tsRightValue':
    '1, solange der Stossfänger nur rechts gedrückt ist. 0 auch, wenn nur einer der Liniensensoren Helles sieht.',
  'callibot.setLED': 'Beide roten Lichter: 1 ein, 0 aus.',
  'callibot.setLEDLeft': 'Linkes rotes Licht: 1 ein, 0 aus. Das rechte geht dabei aus.',
  'callibot.setLEDRight': 'Rechtes rotes Licht: 1 ein, 0 aus. Das linke geht dabei aus.',
  'callibot.setAlarm': 'Zwei Töne immer wieder, im Hintergrund: 1 ein, 0 aus.',
  'callibot.motL': 'Der linke Motor: motL.rotate(50).',
  'callibot.motR': 'Der rechte Motor: motR.rotate(50).',
  'callibot.irLeft': 'Der linke Liniensensor: irLeft.read_digital() ist 1 auf hellem Boden, 0 auf dunklem.',
  'callibot.irRight': 'Der rechte Liniensensor: irRight.read_digital() ist 1 auf hellem Boden, 0 auf dunklem.',
  'callibot.ts': 'Der ganze Stossfänger: ts.getValue() ist 1, solange er links und rechts gedrückt ist.',
  'callibot.tsLeft': 'Der linke Teil des Stossfängers: tsLeft.getValue() ist 1, solange er gedrückt ist.',
  'callibot.tsRight': 'Der rechte Teil des Stossfängers: tsRight.getValue() ist 1, solange er gedrückt ist.',
  'callibot.w':
    'Stellt beide Motoren: Richtung links und rechts (0 vorwärts, 1 rückwärts), Kraft links und rechts (0 bis 255).',
  'callibot.Motor': 'Die Art von motL und motR.',
  'callibot.Motor.rotate': 'Dreht diesen Motor mit einem Tempo von -200 bis 200; negativ ist rückwärts, 0 hält an.',
  'callibot.Sensor': 'Die Art von irLeft, irRight, ts, tsLeft und tsRight.',
  'callibot.Sensor.read_digital': '1 auf hellem Boden oder gedrückt, sonst 0.',
  'callibot.Sensor.getValue': '1 auf hellem Boden oder gedrückt, sonst 0.',
  callibotmot: 'Die zwei Motoren des Calli:bot, jeder einzeln.',
  'callibotmot.motL': 'Der linke Motor: motL.rotate(50).',
  'callibotmot.motR': 'Der rechte Motor: motR.rotate(50).',
  'callibotmot.setLED': 'Beide roten Lichter: 1 ein, 0 aus.',
  'callibotmot.delay': 'Wartet so viele Millisekunden; der Roboter tut unterdessen weiter, was er tut.',
  'callibotmot.Motor': 'Ein Motor: 0 ist der linke, jede andere Zahl der rechte.',
  'callibotmot.Motor.rotate': 'Dreht diesen Motor mit einem Tempo von -200 bis 200; negativ ist rückwärts, 0 hält an.',
  cbalarm: 'Alarmtöne für den Calli:bot.',
  'cbalarm.setAlarm': 'Zwei Töne immer wieder, im Hintergrund: 1 ein, 0 aus.',
  'cbalarm.beep': 'Ein kurzer Ton von 2000 Hertz.',
} as const;

const en: Readonly<Record<keyof typeof de, string>> = {
  callibot: 'Drives the Calli:bot: motors, sensors and red lights.',
  'callibot.forward': 'Drives forward until another command comes.',
  'callibot.backward': 'Drives backward until another command comes.',
  'callibot.left': 'Turns left on the spot until another command comes.',
  'callibot.right': 'Turns right on the spot until another command comes.',
  'callibot.leftArc': 'Drives a circle to the left. radius in metres: 0.2 is 20 cm.',
  'callibot.rightArc': 'Drives a circle to the right. radius in metres: 0.2 is 20 cm.',
  'callibot.stop': 'Stops.',
  'callibot.exit': 'Stops, as stop().',
  'callibot.setSpeed': 'Speed of the following movements, about 10 to 200; 50 at the start.',
  'callibot.delay': 'Waits for this many milliseconds; meanwhile the robot goes on with what it does.',
  'callibot.getDistance': 'Distance to the nearest obstacle in cm, with one decimal.',
  'callibot.irLeftValue': 'Left line sensor: 1 on light ground, 0 on dark ground; 0 also while the bumper is pressed.',
  'callibot.irRightValue':
    'Right line sensor: 1 on light ground, 0 on dark ground; 0 also while the bumper is pressed.',
  'callibot.tsValue':
    '1 while the bumper is pressed left and right. 0 also while only one of the line sensors sees light ground.',
  'callibot.tsLeftValue':
    '1 while the bumper is pressed on the left only. 0 also while only one of the line sensors sees light ground.',
  'callibot.tsRightValue':
    '1 while the bumper is pressed on the right only. 0 also while only one of the line sensors sees light ground.',
  'callibot.setLED': 'Both red lights: 1 on, 0 off.',
  'callibot.setLEDLeft': 'Left red light: 1 on, 0 off. The right one goes off.',
  'callibot.setLEDRight': 'Right red light: 1 on, 0 off. The left one goes off.',
  'callibot.setAlarm': 'Two tones again and again in the background: 1 on, 0 off.',
  'callibot.motL': 'The left motor: motL.rotate(50).',
  'callibot.motR': 'The right motor: motR.rotate(50).',
  'callibot.irLeft': 'The left line sensor: irLeft.read_digital() is 1 on light ground, 0 on dark ground.',
  'callibot.irRight': 'The right line sensor: irRight.read_digital() is 1 on light ground, 0 on dark ground.',
  'callibot.ts': 'The whole bumper: ts.getValue() is 1 while it is pressed left and right.',
  'callibot.tsLeft': 'The left half of the bumper: tsLeft.getValue() is 1 while it is pressed.',
  'callibot.tsRight': 'The right half of the bumper: tsRight.getValue() is 1 while it is pressed.',
  'callibot.w': 'Sets both motors: direction left and right (0 forward, 1 backward), power left and right (0 to 255).',
  'callibot.Motor': 'The kind of motL and motR.',
  'callibot.Motor.rotate': 'Turns this motor with a speed of -200 to 200; negative is backward, 0 stops.',
  'callibot.Sensor': 'The kind of irLeft, irRight, ts, tsLeft and tsRight.',
  'callibot.Sensor.read_digital': '1 on light ground or pressed, else 0.',
  'callibot.Sensor.getValue': '1 on light ground or pressed, else 0.',
  callibotmot: 'The two motors of the Calli:bot, one by one.',
  'callibotmot.motL': 'The left motor: motL.rotate(50).',
  'callibotmot.motR': 'The right motor: motR.rotate(50).',
  'callibotmot.setLED': 'Both red lights: 1 on, 0 off.',
  'callibotmot.delay': 'Waits for this many milliseconds; meanwhile the robot goes on with what it does.',
  'callibotmot.Motor': 'A motor: 0 is the left one, any other number the right one.',
  'callibotmot.Motor.rotate': 'Turns this motor with a speed of -200 to 200; negative is backward, 0 stops.',
  cbalarm: 'Alarm sounds for the Calli:bot.',
  'cbalarm.setAlarm': 'Two tones again and again in the background: 1 on, 0 off.',
  'cbalarm.beep': 'A short tone of 2000 hertz.',
};

/** What the editor knows about the Calli:bot's libraries. */
export const callibotReference: RobotReference = {
  robot: 'callibot',
  modules: [callibotModule, callibotmot, cbalarm],
  texts: { de, en },
};
