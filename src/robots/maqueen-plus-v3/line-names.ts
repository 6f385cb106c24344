/** The line sensors from right to left: the order of their bits and values in the controller. */
export const LINE_NAMES = ['R2', 'R1', 'M', 'L1', 'L2'] as const;

/** A line sensor's name, as printed on the robot. */
export type LineName = (typeof LINE_NAMES)[number];
