/**
 * The Maqueen Mechanic kit "Push": a fixed plate at the front that pushes blocks, and a servo that turns the robot's
 * ultrasonic sensor to the left, ahead and to the right.
 *
 * Source of the behaviour: Copilli's MakeCode extension "Robotics" (three angles, the front plate pushes while
 * driving). Which angle is which is not public: chosen as on most servos with the shaft up, 90° ahead and
 * counter-clockwise for larger angles. Lengths are chosen.
 */
import type { Vec } from '#core/geometry';
import attachmentAbout from '../words/about';
import type { Attachment, AttachmentContext, AttachmentType } from '../attachment';
import { box, onRobot } from '../mount';
import { attachmentTitles } from '../options';

/** Angle of the servo with the sensor looking ahead. */
export const AHEAD_DEG = 90;

const WING: readonly Vec[] = [
  { x: 4, y: 33 },
  { x: 7, y: 33 },
  { x: 15, y: 42 },
  { x: 12, y: 43 },
];

/** The plate, as wide as the robot, with two short wings that stop a block from slipping off in curves. */
const PLATE: readonly (readonly Vec[])[] = [
  box(0, 7, -34, 34),
  WING,
  WING.map(({ x, y }) => ({ x, y: -y })).reverse(), // mirrored, and counter-clockwise again
];

export const push: AttachmentType = {
  id: 'push',
  title: attachmentTitles.push,
  about: attachmentAbout.push,
  restDeg: AHEAD_DEG,
  attach,
};

function attach(context: AttachmentContext): Attachment {
  const parts = PLATE.map((outline) => context.chassis.addPart(onRobot(context, outline)));
  let turnRad = 0;
  return {
    move: (angleDeg) => {
      turnRad = ((angleDeg - AHEAD_DEG) / 180) * Math.PI;
    },
    isHolding: () => false,
    sonarTurnRad: () => turnRad,
    pose: () => ({ turnRad: { sonar: turnRad }, heightMm: 0 }),
    remove: () => parts.forEach((part) => part.remove()),
  };
}
