import type { DeviceSnapshot } from '#simulation/snapshot';

/** True if the motors turn: they go on when the program is over, as on the real robot. */
export function isDriving(device: DeviceSnapshot | null): boolean {
  const duty = device?.robot?.state.duty;
  return duty !== undefined && (duty.left !== 0 || duty.right !== 0);
}

/** True if something of a device still moves or sounds. */
export const stirs = (device: DeviceSnapshot): boolean =>
  isDriving(device) || device.isSounding || device.motors.some((duty) => duty !== 0);
