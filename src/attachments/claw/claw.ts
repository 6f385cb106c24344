/**
 * The claw of the Maqueen Mechanic kit "Beetle": two curved jaws that one servo swings together through gears.
 *
 *      x ↑      ╲      ╱       open: 30°, the tips 75 mm apart
 *        │   ╱        ╲
 *        │  ╲          ╱       closed: 86°, the tips touch
 *        │   o┐      ┌o        o = hinges
 *        │ ───┴──────┴───      the robot's front edge
 *
 * Sources: angles from informatiquecsud/mbrobot `mbtools.py` and `demo_beetle.py` (open 30°, close 86°, valid
 * 30 … 110°, typically closed with 90 … 100°). No drawing of the kit is public: all lengths are chosen, so that a block
 * of 5 cm goes in with room on both sides and is held beyond its middle.
 */
import type { Vec } from '#core/geometry';
import type { GripperType } from '#world/chassis';
import attachmentAbout from '../words/about';
import type { Attachment, AttachmentContext, AttachmentType } from '../attachment';
import { box, onRobot, shareOfWay } from '../mount';
import { attachmentTitles } from '../options';

/** Angle of the servo with the claw wide open; below it the jaws rest against their stops. */
export const OPEN_DEG = 30;

/** Angle at which the tips meet; beyond it the servo only presses harder. */
export const CLOSED_DEG = 86;

const OPEN_SWING_RAD = (50 / 180) * Math.PI; // chosen: tips 75 mm apart

/** The part that carries the hinges; it stops a block. */
const BASE: readonly Vec[] = box(0, 11, -18, 18);

/** Hinge of the left jaw. */
const HINGE: Vec = { x: 12, y: 15 };

/** The left jaw pointing forward, from its hinge: outwards, then inwards to a tip 44 mm away. */
const JAW: readonly (readonly Vec[])[] = [
  [
    { x: -1, y: -3 },
    { x: 22, y: 9 },
    { x: 20, y: 14 },
    { x: -3, y: 2 },
  ],
  [
    { x: 19.5, y: 9.5 },
    { x: 41, y: -14 },
    { x: 44, y: -12 },
    { x: 22.5, y: 13.5 },
  ],
];

/**
 * How hard a tip presses. Tower Pro MG90S data sheet: stall torque 1.8 kg·cm at 4.8 V, that is 0.18 N·m; at 44 mm and
 * shared between two jaws 2 N.
 */
const FORCE_N = 2;

export const claw: AttachmentType = {
  id: 'claw',
  title: attachmentTitles.claw,
  about: attachmentAbout.claw,
  restDeg: OPEN_DEG,
  attach,
};

function attach(context: AttachmentContext): Attachment {
  const { chassis, mountMm, scale } = context;
  const type: GripperType = {
    hingeMm: { x: (mountMm.x + HINGE.x) * scale, y: HINGE.y * scale },
    jawMm: JAW.map((part) => part.map(({ x, y }) => ({ x: x * scale, y: y * scale }))),
    forceN: FORCE_N * scale,
  };
  const base = chassis.addPart(onRobot(context, BASE));
  const gripper = chassis.addGripper(type);
  return {
    move: (angleDeg) => gripper.setSwing(OPEN_SWING_RAD * (1 - shareOfWay(angleDeg, OPEN_DEG, CLOSED_DEG))),
    isHolding: () => gripper.isHolding(),
    sonarTurnRad: () => 0,
    pose: () => {
      const swing = gripper.swingRad();
      return { turnRad: { 'jaw-left': swing, 'jaw-right': -swing }, heightMm: 0 };
    },
    remove: () => {
      gripper.remove();
      base.remove();
    },
  };
}
