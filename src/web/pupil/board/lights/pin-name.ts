/** A pin as pupils write it: `2` for the wire `P2`. */
export const pinName = (wire: string): string => wire.replace(/^P(?=\d)/, '');
