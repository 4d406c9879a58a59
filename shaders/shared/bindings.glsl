// Where what C++ hands over reaches the shaders: binding points and the locations of uniforms, for both
// languages. Every texture has a unit of its own, so that no pass takes away what another has bound.

// Uniform blocks (shaders/lib/frame_blocks.glsl).
const int kViewBlock = 0;
const int kLightBlock = 1;
const int kFieldBlock = 2;

// Storage buffers, by what a pass uses them for: OpenGL promises only eight.
const int kResultBuffer = 0;  // what a compute shader writes
const int kThingBuffer = 1;   // what a draw reads of each thing that it draws

// Textures and buffer textures.
const int kCellUnit = 0;
const int kCellTableUnit = 1;
const int kCellOfGroupUnit = 2;
const int kSpeciesUnit = 3;
const int kTouchedCellUnit = 4;
const int kTouchedSlotUnit = 5;
const int kTouchedChainUnit = 6;
const int kSwayUnit = 7;
const int kTreadUnit = 8;
const int kConditionUnit = 9;
const int kSwardFreeUnit = 10;
const int kSwardShadedUnit = 11;
const int kStripTileUnit = 12;
const int kStripTraitsUnit = 13;
const int kStripUnit = 14;
const int kFlatMapUnit = 15;
const int kTileMorphUnit = 16;
const int kNoiseUnit = 17;
const int kSkyMapUnit = 18;
const int kObstacleAlbedoUnit = 19;
const int kObstacleSurfaceUnit = 20;
const int kStoneAlbedoUnit = 21;
const int kStoneSurfaceUnit = 22;
const int kLinearPictureUnit = 23;

// Uniforms, by program.
const int kPlantBladeCount = 0;  // of every program that plants
const int kGrowSegments = 1;
const int kGrowFirstVertex = 2;
const int kLayColumnCount = 0;
const int kLayFirstTile = 1;
const int kLayFirstColumn = 2;
const int kLayQuads = 3;
const int kStripBladeVertices = 0;
const int kStripBladeCount = 1;
const int kStripBladeShift = 2;
const int kStripBladeAlong = 3;
const int kStripBladeHeight = 4;
const int kGroundVerticesPerSide = 0;
const int kFirstThing = 0;  // of every program that draws instances of things
const int kObstacleOrigin = 0;
const int kObstacleTexels = 0;
const int kObstaclePlaces = 1;
const int kStoneTexels = 0;
const int kStoneAlbedo = 1;
const int kSkyDirections = 0;
const int kOverlayShown = 0;  // of fields and of lines
const int kLineSize = 1;
const int kLineHalfWidth = 2;
const int kToneExposure = 0;
