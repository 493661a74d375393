/* What stands between the braces is the lecture's, untouched. */

static const GLubyte
myDemonTextureImage[3*(128*128)] = {
/* RGB8 image data for a mipmapped 128x128
   demon texture */
#include "demon_image.h"
};

static void setup(void)
{
/* Tightly packed texture data. */
glPixelStorei(GL_UNPACK_ALIGNMENT, 1);

glBindTexture(GL_TEXTURE_2D, 666);
/* Load demon decal texture with mipmaps. */
gluBuild2DMipmaps(GL_TEXTURE_2D, GL_RGB8,
128, 128, GL_RGB, GL_UNSIGNED_BYTE,
myDemonTextureImage);
glTexParameteri(GL_TEXTURE_2D,
GL_TEXTURE_MIN_FILTER,
GL_LINEAR_MIPMAP_LINEAR);

glActiveTexture(GL_TEXTURE0);
glTexEnvf(GL_TEXTURE_ENV,
GL_TEXTURE_ENV_MODE, GL_REPLACE);
glEnable(GL_TEXTURE_2D);
glBindTexture(GL_TEXTURE_2D, 666);
}

static void draw(void)
{
glBegin (GL_TRIANGLES);
glTexCoord2f (0, 0);
glVertex2f (-0.8, 0.8);
glTexCoord2f (1, 0);
glVertex2f (0.8, 0.8);
glTexCoord2f (0.5, 1);
glVertex2f (0.0, -0.8);
glEnd ();
}
