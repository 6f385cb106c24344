/** Faulty programs: the solutions of ready courses, each with one fault. */
import type { HintKind } from '../changes/change';

/** One fault: this part of the solution is replaced by that. It is there once. */
export interface Fault {
  readonly course: string;
  readonly kind: HintKind;
  readonly right: string;
  readonly wrong: string;
}

const on =
  (course: string) =>
  (kind: HintKind, right: string, wrong: string): Fault => ({ course, kind, right, wrong });

const [line, bends, corners, square, slalom] = ['closed-line', 's-bends', 'corners', 'square', 'slalom'].map(on);
const [push, parking, maze, carry, guard] = ['push', 'parking', 'small-maze', 'carry', 'guard'].map(on);

/** The corpus: ten courses, all kinds. */
export const corpus: readonly Fault[] = [
  line!('number', 'leftArc(0.06)', 'leftArc(1.5)'),
  line!('number', 'leftArc(0.06)', 'leftArc(0.6)'),
  line!('number', 'rightArc(0.06)', 'rightArc(0.5)'),
  line!('number', 'delay(10)', 'delay(700)'),
  line!('name', 'rightArc(0.06)', 'leftArc(0.06)'),
  line!('name', 'leftArc(0.06)', 'rightArc(0.06)'),
  line!('name', 'left_bright = irLeft', 'left_bright = irRight'),
  line!('name', 'forward()   ', 'backward()   '),
  line!('logic', 'elif not left_bright', 'elif left_bright'),
  line!('logic', 'not left_bright and not right_bright', 'left_bright and not right_bright'),
  line!('extra', '    delay(10)', '    forward()\n    delay(10)'),
  line!('extra', '    delay(10)', '    delay(10)\n    break'),
  line!('missing', '        forward()           # in the middle of the line\n', '        stop()\n'),
  line!('indent', '        rightArc(0.06)      # the line', '    rightArc(0.06)      # the line'),
  line!('missing', '    right_bright = irRight.read_digital()\n', ''),

  bends!('number', 'delay(5)', 'delay(500)'),
  bends!('polarity', 'irLeft.read_digital() == 0', 'irLeft.read_digital() == 1'),
  bends!('polarity', 'irRight.read_digital() == 0', 'irRight.read_digital() == 1'),
  bends!('logic', 'left_dark and right_dark', 'left_dark or right_dark'),
  bends!('name', '        right()', '        left()'),
  bends!('name', 'irLeft.read', 'irRight.read'),
  bends!('comparison', 'irLeft.read_digital() == 0', 'irLeft.read_digital() != 0'),

  corners!('number', 'TO_WHEELS = 370', 'TO_WHEELS = 3700'),
  corners!('polarity', 'sensor.read_digital() == 0', 'sensor.read_digital() == 1'),
  corners!('name', 'turn_corner(left)', 'turn_corner(right)'),
  corners!('name', 'if is_dark(irL2)', 'if is_dark(irR2)'),
  corners!('logic', 'while not is_dark(irM)', 'while is_dark(irM)'),
  corners!('missing', '    direction()         # left or right\n', ''),
  corners!('comparison', 'sensor.read_digital() == 0', 'sensor.read_digital() > 0'),
  corners!('extra', '    delay(10)', '    delay(10)\n    stop()\n    delay(TO_WHEELS)'),

  square!('number', 'SIDE = 2200', 'SIDE = 1200'),
  square!('number', 'QUARTER_TURN = 372', 'QUARTER_TURN = 300'),
  square!('number', 'QUARTER_TURN = 372', 'QUARTER_TURN = 500'),
  square!('number', 'setSpeed(50)\n\n', 'setSpeed(30)\n\n'),
  square!('number', 'range(4)', 'range(3)'),
  square!('name', 'left()', 'right()'),
  square!('name', 'forward()', 'backward()'),
  square!('name', 'delay(SIDE)', 'delay(QUARTER_TURN)'),
  square!('missing', '    delay(SIDE)\n', ''),
  square!('missing', '    left()\n', ''),
  square!('missing', '    delay(QUARTER_TURN)\n    stop()', '    stop()'),
  square!('missing', '    forward()\n', ''),
  square!('extra', '    left()\n', '    left()\n    stop()\n'),
  square!('extra', '    left()\n', '    left()\n    delay(200)\n'),
  square!('order', '    left()\n    delay(QUARTER_TURN)\n', '    delay(QUARTER_TURN)\n    left()\n'),
  square!('order', '    forward()\n    delay(SIDE)\n', '    delay(SIDE)\n    forward()\n'),

  slalom!('number', 'HALF_CIRCLE = 3825', 'HALF_CIRCLE = 2800'),
  slalom!('number', 'arc(0.2)', 'arc(0.35)'),
  slalom!('number', 'range(2)', 'range(1)'),
  slalom!('number', 'setSpeed(50)\n\nfor', 'setSpeed(30)\n\nfor'),
  slalom!('name', 'half_circle(rightArc)', 'half_circle(leftArc)'),
  slalom!('missing', '    half_circle(leftArc)\n', ''),
  slalom!('missing', '    delay(HALF_CIRCLE)\n', ''),
  slalom!('order', '    half_circle(rightArc)\n    half_circle(leftArc)', '    half_circle(leftArc)\n    half_circle(rightArc)'),
  slalom!('order', '    delay(HALF_CIRCLE)\n    stop()\n', '    stop()\n    delay(HALF_CIRCLE)\n'),
  slalom!('extra', '    delay(HALF_CIRCLE)\n', '    delay(HALF_CIRCLE)\n    delay(300)\n'),
  slalom!('indent', '    half_circle(leftArc)\n', 'half_circle(leftArc)\n'),

  push!('polarity', 'irLeft.read_digital() == 1', 'irLeft.read_digital() == 0'),
  push!('name', 'forward()\nwhile', 'backward()\nwhile'),
  push!('number', 'setSpeed(50)', 'setSpeed(1)'),
  push!('number', 'setSpeed(50)\n\n', 'setSpeed(0)\n\n'),
  push!('missing', 'forward()\nwhile', 'while'),
  push!('extra', '    delay(10)\nstop()', '    delay(10)\n    break\nstop()'),
  push!('logic', 'while irLeft', 'if irLeft'),
  push!('extra', 'forward()\nwhile', 'forward()\nstop()\nwhile'),
  push!('logic', 'irLeft.read_digital() == 1 and', 'irLeft.read_digital() == 1 and not'),
  push!('comparison', 'irRight.read_digital() == 1', 'irRight.read_digital() < 1'),

  parking!('number', 'QUARTER_TURN = 590', 'QUARTER_TURN = 400'),
  parking!('number', 'INTO_SPACE = 2300', 'INTO_SPACE = 1200'),
  parking!('name', 'left()                  #', 'right()                 #'),
  parking!('name', 'backward()', 'forward()'),
  parking!('name', 'delay(QUARTER_TURN)', 'delay(INTO_SPACE)'),
  parking!('polarity', 'irM.read_digital() == 1', 'irM.read_digital() == 0'),
  parking!('missing', 'delay(INTO_SPACE)\n', ''),
  parking!('missing', 'delay(QUARTER_TURN)\n', ''),
  parking!('order', 'backward()\ndelay(INTO_SPACE)', 'delay(INTO_SPACE)\nbackward()'),
  parking!('comparison', 'irM.read_digital() == 1', 'irM.read_digital() != 1'),
  parking!('logic', 'while irM', 'if irM'),

  maze!('number', 'QUARTER_TURN = 372', 'QUARTER_TURN = 250'),
  maze!('number', 'NEAR = 6 ', 'NEAR = 60 '),
  maze!('number', 'getDistance() < 20', 'getDistance() < 2'),
  maze!('comparison', 'getDistance() > NEAR', 'getDistance() < NEAR'),
  maze!('comparison', 'getDistance() < 20', 'getDistance() > 20'),
  maze!('logic', 'while not at_finish()', 'while at_finish()'),
  maze!('logic', 'irLeft.read_digital() == 0 and', 'irLeft.read_digital() == 0 or not'),
  maze!('missing', '            turn(right)\n            turn(right)', '            turn(right)'),
  maze!('extra', '        turn(left)\n', '        turn(left)\n        turn(left)\n'),
  maze!('indent', '            turn(right)\n            turn(right)\n', '            turn(right)\n        turn(right)\n'),
  maze!('missing', '    delay(QUARTER_TURN)\n', ''),

  carry!('number', 'QUARTER_TURN = 363', 'QUARTER_TURN = 250'),
  carry!('number', 'CLOSED = 90', 'CLOSED = 40'),
  carry!('name', 'turn(left)', 'turn(right)'),
  carry!('comparison', 'getDistance() > 4', 'getDistance() < 4'),
  carry!('missing', 'drive_to_line()\nforward', 'forward'),
  carry!('name', 'setServo("S1", CLOSED)', 'setServo("S1", OPEN)'),
  carry!('polarity', 'irLeft.read_digital() == 1 and', 'irLeft.read_digital() == 0 and'),
  carry!('missing', 'delay(1500)\n', ''),

  guard!('number', 'QUARTER_TURN = 353', 'QUARTER_TURN = 500'),
  guard!('number', 'drive(2750)', 'drive(1500)'),
  guard!('number', 'drive(1500)', 'drive(500)'),
  guard!('name', 'turn(right, QUARTER_TURN)\ndrive(1500)', 'turn(left, QUARTER_TURN)\ndrive(1500)'),
  guard!('name', 'turn(right, QUARTER_TURN)\ndrive(4900)', 'turn(right, EIGHTH_TURN)\ndrive(4900)'),
  guard!('comparison', 'getDistance() > NEAR', 'getDistance() < NEAR'),
  guard!('missing', 'turn(left, EIGHTH_TURN)         # away, past it\n', ''),
  guard!('missing', 'drive(2750)\n', ''),
  guard!('extra', 'drive(2750)\n', 'drive(2750)\nturn(left, EIGHTH_TURN)\n'),
  guard!('order', 'drive(2750)\nturn(right, QUARTER_TURN)', 'turn(right, QUARTER_TURN)\ndrive(2750)'),
]; // prettier-ignore

/** A solution with a fault, and the number of the first line that is not right. Throws where the part is not there once. */
export function faulty(
  solution: string,
  { right, wrong, course }: Fault,
): { readonly text: string; readonly line: number } {
  const at = solution.indexOf(right);
  if (at < 0 || solution.indexOf(right, at + 1) >= 0) throw new Error(`${course}: "${right}" is not there once.`);
  let same = 0;
  while (same < Math.min(right.length, wrong.length) && right[same] === wrong[same]) same += 1;
  const text = solution.slice(0, at) + wrong + solution.slice(at + right.length);
  return { text, line: text.slice(0, at + same).split('\n').length };
}
