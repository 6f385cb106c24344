import { Sensors, type SensorInfo } from '#board/sensors/sensors';

export type { SensorInfo } from '#board/sensors/sensors';

/** A sensor that takes numbers. */
export type RangeInfo = Extract<SensorInfo, { kind: 'range' }>;

/** Every board's sensors and their ranges, before any run; the board's pins say what can be pressed. */
export const sensorInfos: readonly SensorInfo[] = new Sensors(new Map()).describe();
