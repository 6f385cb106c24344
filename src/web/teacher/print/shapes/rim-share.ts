/** Room around an arena without rulers, in parts of its longer side. */
export const RIM_SHARE = 0.004;
