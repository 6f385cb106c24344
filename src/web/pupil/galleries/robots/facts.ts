import type { RegisterTable, RobotType } from '#robots/robot';

/** A bus address as data sheets write it: `0x10`. */
export const addressText = (address: number): string => `0x${address.toString(16).padStart(2, '0').toUpperCase()}`;

/** The addresses whose registers a table lists: `0x10`, or `0x23 … 0x27` for several. */
export const addressesText = ({
  address,
  lastAddress = address,
}: Pick<RegisterTable, 'address' | 'lastAddress'>): string =>
  lastAddress === address ? addressText(address) : `${addressText(address)} … ${addressText(lastAddress)}`;

/** Length and width of the robot's outline, in whole centimetres. */
export function sizeCm({ body }: RobotType): { readonly length: number; readonly width: number } {
  const corners = body.outlineMm.flat();
  const extent = (values: readonly number[]): number => Math.round((Math.max(...values) - Math.min(...values)) / 10);
  return { length: extent(corners.map(({ x }) => x)), width: extent(corners.map(({ y }) => y)) };
}
