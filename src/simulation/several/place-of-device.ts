/**
 * The place of a device by its name.
 *
 * @param names of all devices, in their order
 * @param device left out: the first
 * @returns a sentence that names the known ones, if there is no such device
 */
export function placeOfDevice(names: readonly string[], device: string | undefined): number | string {
  const place = device === undefined ? 0 : names.indexOf(device);
  const known = names.map((name) => `"${name}"`).join(', ');
  return place >= 0 ? place : `There is no device "${device ?? ''}". Known are ${known}.`;
}
