import { Sensors, type SensorInfo } from '#board/sensors/sensors';

export type { SensorInfo } from '#board/sensors/sensors';

/** A sensor that takes numbers. */
export type RangeInfo = Extract<SensorInfo, { kind: 'range' }>;

/** What every board feels and in which ranges, before any run; what can be pressed is told by the board's pins. */
export const sensorInfos: readonly SensorInfo[] = new Sensors(new Map()).describe();
