/** What the first view says of riding. */
export const firstWords = {
  ride: 'Ride it',
  title: 'Steer the board yourself, by keys, touch, gamepad or a phone’s tilt',
  keyLine: 'steer the board yourself',
};
