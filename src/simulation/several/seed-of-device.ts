/** The seed of a device of a run: the first has the run's, each other one that lies far from it. A whole number. */
export const seedOfDevice = (seed: number, place: number): number =>
  place === 0 ? seed : (seed + Math.imul(place, 0x9e3779b1)) | 0; // 2³² divided by the golden ratio spreads them evenly
