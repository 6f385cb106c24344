/**
 * The look of a curve: colour, dashes and the shape of its points tell it apart. Given in the order in which curves are
 * chosen.
 */
export interface Look {
  /** The custom property of its colour: `chart.css`. */
  readonly colour: string;
  /** Lengths of dashes and gaps in px; none for a solid line. */
  readonly dash: readonly number[];
  /** Outline of a point as the path of an SVG, around the origin, 4 px in radius. */
  readonly point: string;
}

export const looks: readonly Look[] = [
  { colour: '--curve-1', dash: [], point: 'M4 0A4 4 0 1 1-4 0A4 4 0 1 1 4 0Z' },
  { colour: '--curve-2', dash: [9, 5], point: 'M-3.6-3.6H3.6V3.6H-3.6Z' },
  { colour: '--curve-3', dash: [2.5, 4], point: 'M0-5.2L5.2 0L0 5.2L-5.2 0Z' },
  { colour: '--curve-4', dash: [12, 4, 2.5, 4], point: 'M0-5L4.8 3.6H-4.8Z' },
];

/** Most curves that are drawn at once: more could not be told apart. */
export const MOST_CURVES = looks.length;

export const lookAt = (place: number): Look => looks[place % looks.length] ?? (looks[0] as Look);
