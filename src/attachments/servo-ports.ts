import type { OptionValues } from '#core/option';
import type { Stop } from '#core/stop';
import { createServo } from '#devices/servo';
import { STEP_US } from '#world/step';
import type { AttachmentContext, AttachmentState } from './attachment';
import { findAttachment } from './types';

/** The servo ports of one robot with what hangs on them. */
export interface ServoPorts {
  /** Sets a servo's target angle for the program: degrees, 0 … 180, clamped. The servo turns at its own speed. */
  set(port: string, angleDeg: number): void;
  /** Call it after each step of the world. */
  step(): void;
  /** Angle by which the distance sensor is turned away from forward, in rad, left positive. */
  sonarTurnRad(): number;
  /** Angle by port as the program set it, for each servo that was ever set. */
  servos(): Readonly<Record<string, number>>;
  attachments(): readonly AttachmentState[];
  readonly stop: Stop;
}

/** Angle of a servo without an attachment at the start: its arm is in the middle. */
const BARE_DEG = 90;

/**
 * Puts a servo on each port, and on the servo the attachment that the option of the same name chooses.
 *
 * All of them are fixed to the same place, so two go together as in the kit with two servos: a lift and a claw lift
 * what the claw holds, a pusher's sensor turns above a claw. Two of the same kind overlap completely.
 *
 * @param mount `null`: servos only
 */
export function attachServoPorts(
  ports: readonly string[],
  options: OptionValues,
  mount: AttachmentContext | null,
): ServoPorts {
  const all = ports.map((port) => attachPort(port, options[port], mount));
  return {
    set: (port, angleDeg) => all.find((candidate) => candidate.name === port)?.set(angleDeg),
    step: () => all.forEach((port) => port.step()),
    sonarTurnRad: () => all.reduce((sum, port) => sum + port.sonarTurnRad(), 0),
    servos: () => {
      const set: Record<string, number> = {};
      for (const { name, setDeg } of all) if (setDeg !== null) set[name] = setDeg;
      return set;
    },
    attachments: () => all.flatMap((port) => port.state() ?? []),
    stop: () => all.forEach((port) => port.stop()),
  };
}

interface Port {
  readonly name: string;
  /** As the program set it, or `null` if it never did. */
  readonly setDeg: number | null;
  set(angleDeg: number): void;
  step(): void;
  sonarTurnRad(): number;
  state(): AttachmentState | null;
  readonly stop: Stop;
}

function attachPort(name: string, choice: string | undefined, mount: AttachmentContext | null): Port {
  const type = findAttachment(choice);
  const attachment = type && mount && type.attach(mount);
  const servo = createServo(type?.restDeg ?? BARE_DEG);
  let setDeg: number | null = null;
  attachment?.move(servo.angleDeg);
  return {
    name,
    get setDeg() {
      return setDeg;
    },
    set: (angleDeg) => {
      setDeg = Math.min(Math.max(angleDeg, 0), 180);
      servo.set(setDeg);
    },
    step: () => {
      const before = servo.angleDeg;
      servo.pass(STEP_US);
      if (servo.angleDeg !== before) attachment?.move(servo.angleDeg);
    },
    sonarTurnRad: () => attachment?.sonarTurnRad() ?? 0,
    state: () =>
      type && attachment && mount
        ? {
            ...attachment.pose(),
            type: type.id,
            port: name,
            atMm: mount.mountMm,
            angleDeg: servo.angleDeg,
            isHolding: attachment.isHolding(),
          }
        : null,
    stop: () => attachment?.remove(),
  };
}
