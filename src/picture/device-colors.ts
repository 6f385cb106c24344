/** The colours of devices on the floor, which is light in every theme: those of the light theme in `devices.css`. */
const COLORS = ['#1e66d0', '#a3278f', '#0b7a75', '#8a5200', '#5b3fb8', '#3f6b00', '#b0305a', '#4a5560'] as const;

/** A colour by its number among `robotColors`; without a wish of the course that is the place of the device. */
export const deviceColor = (number: number): string => COLORS[number % COLORS.length] ?? COLORS[0];
