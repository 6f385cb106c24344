/**
 * DFRobot Maqueen Lite (micro:Maqueen V3, V4 and V5): its wiring. Frame and units: see ../robot.ts. Where each number
 * comes from: SOURCES.md; NOE = NoeSchaller/TS_Maqueen, ETH = Tiger-Jython/Robotics-Libraries, DF = DFRobot
 * pxt-maqueen.
 *
 *      P0  buzzer              P8   red LED left       I2C 0x10  motors, servos S1 S2, version; additions of the V5: v5.ts
 *      P1  ultrasonic trigger  P12  red LED right
 *      P2  ultrasonic echo     P13  line sensor left
 *      P15 four RGB LEDs       P14  line sensor right
 *      P16 infrared receiver
 */
import type { Vec } from '#core/geometry';
import { signedDuty } from '#devices/dc-motor';
import { attachIrReceiver } from '#devices/ir-receiver';
import { attachHcSr04 } from '#devices/hc-sr04';
import { ledOn } from '#devices/led';
import { attachLineSensor } from '#devices/line-sensor';
import { attachWs2812 } from '#devices/ws2812';
import { echoOf } from '../echo';
import { mountLinePair } from '../line-row';
import { mountMotors, mountServos, tellColors } from '../mounting';
import {
  bareState,
  noLights,
  type Robot,
  type RobotBuild,
  type RobotContext,
  type RobotLights,
  type RobotState,
} from '../robot';
import { mountSonar, SR04_CONE } from '../sonar';
import { CONTROLLER_ADDRESS, createController } from './controller';
import mbalarm from './library/mbalarm.py?raw';
import mbled from './library/mbled.py?raw';
import mbrobot from './library/mbrobot.py?raw';
import mbrobotmot from './library/mbrobotmot.py?raw';
import { maqueenLite as type, SERVO_PORTS } from './type';
import { mountV5 } from './v5';

const LINE_AT = { left: { x: 34, y: 7 }, right: { x: 34, y: -7 } } as const; // NOE
const LINE_PIN = { left: 'P13', right: 'P14' } as const;
const LINE_SPOT_RADIUS_MM = 2.5; // chosen: the usual reflective sensor sees a spot as wide as its housing, 5 mm

/** NOE draws the sensor 53 mm ahead of the axle, the body ends at 58: chosen in between, where the two cans end. */
const SONAR_AT: Vec = { x: 55, y: 0 };

const RGB_COUNT = 4; // front left, back left, back right, front right: ETH mbrobot.py

const WIRES: Robot['wires'] = {
  ...{ P1: [], P2: [], P13: [], P14: [], P15: [], P16: [] },
  P8: ['light-left'],
  P12: ['light-right'],
};

export const maqueenLiteBuild: RobotBuild = {
  type,
  libraries: { 'mbrobot.py': mbrobot, 'mbrobotmot.py': mbrobotmot, 'mbalarm.py': mbalarm, 'mbled.py': mbled },
  attach,
};

function attach(context: RobotContext): Robot {
  const { board, clock } = context;
  const servos = mountServos(context, type, SERVO_PORTS);
  const motors = mountMotors(context);
  const v5 = mountV5(context, motors, { ...LINE_AT, spotRadiusMm: LINE_SPOT_RADIUS_MM });
  const controller = createController(
    {
      motors: (left, right, sides) =>
        motors.set(signedDuty(left.direction, left.speed), signedDuty(right.direction, right.speed), sides),
      servo: (port, angleDeg) => servos.set(port, angleDeg),
    },
    v5.registers,
  );
  const sonar = mountSonar(context, { atMm: SONAR_AT, cone: SR04_CONE, turnRad: () => servos.sonarTurnRad() });
  const line = mountLinePair(context, LINE_AT, LINE_SPOT_RADIUS_MM, (view, side) =>
    attachLineSensor(board.wire(LINE_PIN[side]), view),
  );
  const underglow = attachWs2812(board.wire('P15'), RGB_COUNT, tellColors(context));
  const leds = { left: ledOn(board.wire('P8')), right: ledOn(board.wire('P12')) };
  const stops = [
    board.i2c.attach(CONTROLLER_ADDRESS, controller),
    attachHcSr04(
      clock,
      { trigger: board.wire('P1'), echo: board.wire('P2') },
      sonar.distanceMm,
      echoOf(context.options),
    ),
    line.stop,
    v5.stop,
    attachIrReceiver(board.wire('P16'), context.infrared),
    underglow.stop,
    servos.stop,
    motors.stop,
  ];

  const lights = (): RobotLights => ({
    ...noLights,
    leds: { left: leds.left.isLit() || v5.isLit(0) ? 1 : 0, right: leds.right.isLit() || v5.isLit(1) ? 1 : 0 },
    rgb: underglow.colors(),
  });
  const state = (): RobotState => ({
    ...bareState,
    ...lights(),
    lineSensors: line.states(),
    servos: servos.servos(),
    attachments: servos.attachments(),
    duty: motors.duty(),
    ultrasonic: sonar.state(),
  });
  const step = (): void => {
    line.sample();
    v5.step();
    servos.step();
  };
  return { wires: WIRES, lights, state, step, detach: () => stops.forEach((stop) => stop()) };
}
