import type { Board } from '#board/board';
import { padId } from '#board/sensors/sensors';
import type { Mounted } from './mount-robot';
import type { BoardSnapshot, RobotSnapshot } from './snapshot';

/** The visible state of the board now. */
export function boardSnapshot(board: Board): BoardSnapshot {
  const hz = board.music.frequencyHz;
  return {
    board: board.type.id,
    display: Array.from(board.display.pixels),
    buttons: { a: board.buttonA.isDown, b: board.buttonB.isDown },
    touch: Object.fromEntries(Array.from(board.touch, ([name, pad]) => [padId(name), pad.isDown])),
    rgb: board.rgb,
    motors: board.motors.map(({ duty }) => duty),
    microphoneOn: board.microphone.isListening,
    sensors: Object.fromEntries(board.sensors.ids.map((id) => [id, board.sensors.get(id)])),
    accelerometerRangeMg: board.motion.rangeMg,
    soundThresholds: board.microphone.threshold,
    power: board.power.state,
    radio: { on: board.radio.isOn, group: board.radio.group, channel: board.radio.channel },
    logFull: board.dataLog.isFull,
    sound: hz === null ? null : { hz },
    isSounding: hz !== null || board.sound.isSounding,
  };
}

/** The robot now. */
export function robotSnapshot({ type, chassis, robot }: Mounted, scale: number): RobotSnapshot {
  return {
    type: type.id,
    scale,
    pose: chassis.pose(),
    wheelTurnRad: [chassis.wheelTurnRad(0), chassis.wheelTurnRad(1)],
    state: robot.state(),
    collisions: chassis.collisions(),
    pathMm: chassis.pathMm(),
    turnedRad: chassis.turnedRad(),
  };
}
