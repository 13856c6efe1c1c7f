/** Words of the kit's own controls. */
export const words = {
  close: 'Close',
  differs: (name: string) => `${name} differs from the case: set it back`,
  scrub: 'Drag to change',
  handle: 'Drag to change, press for a slider',
  sliderOf: (name: string) => `Slider for ${name}`,
  stepValue: 'step the value; Shift ×10, Alt ÷10',
  valueUp: 'Step up',
  valueDown: 'Step down',
  save: 'Save',
  png: 'as PNG',
  svg: 'as SVG',
  csv: 'as CSV',
  loading: 'Loading',
  failed: 'This part could not be loaded; check the connection and open it again.',
  outdated: 'This page has a new version, and this part belongs to the old one. What you edited is kept.',
  reload: 'Reload',
} as const;
