export default `system "Stiff decay (y′ = −15 y)"

coordinate y [1] = 1 "value"

parameter rate [1/s] = 15 "rate of decay" group "Decay"

y' = -rate y

body marker at (0, 0, y)
shape marker sphere 0.05
`;
